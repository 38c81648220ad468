G21 G90 G0 X0 Y0 Z0 F100
M19 R1 Q0
M2
; expect bad-value 2:8 linuxcnc | Q of M19 must be above 0 (value Q0); correct Q
