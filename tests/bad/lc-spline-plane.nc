G21 G90 G0 X0 Y0 Z0 F100
G18 G5 X1 Y1 I1 J1 P1 Q1
M2
; expect plane 2:5 linuxcnc | splines lie in the plane XY (value G5); write G17 before
