G21 G90
G1 X1 A5 F100
; expect unknown-word 2:7
