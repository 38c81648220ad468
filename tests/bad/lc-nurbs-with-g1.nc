G21 G90 G0 X0 Y0 Z0 F100
G5.2 P1 X0 Y1
G5.3 G1 X1
M2
; expect axis-conflict 3:6 linuxcnc | G5.3 ends a NURBS: no other motion may share its line (value G1); write it on the next line
