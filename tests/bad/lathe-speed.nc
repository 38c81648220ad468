M03 S100 #
; expect refused-code 1:1 mini-lathe | mini-lathe B does not accept M3 (value M03, limit G0, G1, G20, G21, G70, G71, G90, G91, M2); the spindle's speed is set by hand
