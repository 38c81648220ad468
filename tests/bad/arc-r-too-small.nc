G0 X0 Y0 F100
G2 X10 R4
; expect arc-radius 2:8
