G1 X5
; expect refused-code 1:1 thesis-a
