G21 G64
; expect refused-code 1:5
