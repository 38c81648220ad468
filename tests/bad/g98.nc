G0 X1
G98
; expect refused-code 2:1
