G21 G90 G0 X0 Y0 Z0 F100
M66 P1 L1.4 Q1
M2
; expect bad-value 2:8 linuxcnc | L must be a whole number (value L1.4, limit -2147483648 to 2147483648); correct L
