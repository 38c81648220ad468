G21 G90 F100
G0 X0 Y0
G2 X10 Y0 I5.1 J0
; expect arc-ends 3:1
