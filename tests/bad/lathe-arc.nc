G02 X1. Z1. #
; expect refused-code 1:1 mini-lathe | mini-lathe B does not accept G2 (value G02, limit G0, G1, G20, G21, G70, G71, G90, G91, M2); this lathe moves in straight lines: write the arc as lines
