G21 G90 G0 X0 Y0 Z0 F100
M19 P1.5
M2
; expect bad-value 2:5 linuxcnc | P must be a whole number (value P1.5, limit 0 to 2); correct P
