G21 G90 G0 X0 Y0 Z0 F100
M3 S100
G76 Z-10 P1.5 I1 J0 K1
M2
; expect bad-value 3:18 linuxcnc | J of G76 must be above 0 (value J0); correct J
