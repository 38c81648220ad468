G21 G90 G0 X0 Y0 Z0 F100
G10 L2 P1.4 X1
M2
; expect work-system 2:8 linuxcnc | P must be a whole number (value P1.4, limit 0 to 9); correct P
