F100
G43.1 Z1 G1 X1
M2
; expect axis-conflict 2:10 linuxcnc | G43.1 and G1 would both use the axis words (value G1); write them on two lines
