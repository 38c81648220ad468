G0 X0 Y0
G2 X2 Y0.1 I1 J0 F100
; expect arc-ends 2:1 mach | the radius at the end of the arc is 1.0050 mm and at its start 1.0000 mm (value G2, limit a difference of 0.0020 mm); correct the centre or the end point
