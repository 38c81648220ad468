G21 G90 G0 X0 Y0 Z0 F100
G5.2 X1 Y1 P1
X2 Y1
M2
; expect bad-value 3:1 linuxcnc | a control point needs a weight P above 0 (value X2); add P
