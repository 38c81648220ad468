G0 X0 Y0 F100
G2 X0 R4
; expect arc-ends 2:7
