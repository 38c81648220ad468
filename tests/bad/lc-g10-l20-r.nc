G21 G90 G0 X0 Y0 Z0 F100
G10 L20 P1 R1
M2
; expect unused-word 2:12 linuxcnc | R has no meaning with G10 L20 (value R1); drop it
