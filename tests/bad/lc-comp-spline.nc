G21 G90 G0 X0 Y0 Z0 F100
G41.1 D2
G1 X10
G5 X1 Y1 I1 J1 P1 Q1
M2
; expect compensation 4:1 linuxcnc | no spline may be cut while the tool is compensated (value G5); write G40 before
