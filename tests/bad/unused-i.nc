G21
G1 X1 I5 F100
; expect unused-word 2:7
