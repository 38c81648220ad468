G21 G90 G0 X0 Y0 Z0 F100
G10 L2 P1 I1
M2
; expect unused-word 2:11 linuxcnc | I has no meaning with G10 L2 (value I1); drop it
