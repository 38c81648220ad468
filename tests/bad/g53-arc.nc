G0 X0 Y0 F100
G53 G2 X1 I.5
; expect machine-move 2:1
