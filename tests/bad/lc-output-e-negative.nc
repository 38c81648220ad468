G21 G90 G0 X0 Y0 Z0 F100
M67 E-1 Q1
M2
; expect bad-value 2:5 linuxcnc | E may not be negative (value E-1); correct E
