G21 G90 G0 X0 Y0 Z0
G80 F100
G5.1 X1 Y1 I1 J1
X4 Y4
M2
; expect no-motion 4:1 linuxcnc | there is no motion that the coordinates could belong to (value X4); write G0, G1, G2 or G3
