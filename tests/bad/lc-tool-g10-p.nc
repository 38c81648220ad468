G21 G90 G0 X0 Y0 Z0 F100
G10 L1 P0 X1
M2
; expect bad-value 2:8 linuxcnc | P must be a whole number (value P0, limit 1 to 2147483647); correct P
