G21 G90 G0 X0 Y0 Z0 F100
M3 S100
G76 Z-10 P1.5 I0 J.3 K1
M2
; expect bad-value 3:15 linuxcnc | I of G76 may not be 0 (value I0); correct I
