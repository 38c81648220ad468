G21 G90 G0 X0 Y0 Z0 F100
G41.1 D2
G1 X10
G10 L2 P1 X1
M2
; expect compensation 4:1 linuxcnc | the coordinate system in force may not be changed while the tool is compensated (value G10); write G40 before
