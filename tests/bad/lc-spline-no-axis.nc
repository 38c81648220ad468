G21 G90 G0 X0 Y0 Z0 F100
G5.1 I1 J1
M2
; expect missing-axis 2:1 linuxcnc | G5.1 needs X, Y or Z (value G5.1); add one
