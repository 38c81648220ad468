G21 G90 G0 X0 Y0 Z0 F100
S100 M4
G74 X1 Z-1 R1 L2
M2
; expect unused-word 3:15 linuxcnc | no code on this line uses the word L (value L2); take it out or add its code
