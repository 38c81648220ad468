G21 G90 G0 X0 Y0 Z0 F100
M3 S100
G76 Z-10 P1.5 I1 J2 K1
M2
; expect bad-value 3:21 linuxcnc | K of G76 must be above J (value K1); correct K
