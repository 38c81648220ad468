G21 G90 G0 X0 Y0 Z0 F100
G10 L3 P1
M2
; expect not-supported 2:5 linuxcnc | G10 is read with L1, L2, L10, L11 and L20 only (value L3); correct L
