G0 X0 Y0 F100
G2 X0.001 Y0 I0.0005 J-90000
; expect arc-angle 2:1
