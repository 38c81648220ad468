G21 G90 G0 X0 Y0 Z0 F100
G52
M2
; expect missing-axis 2:1 linuxcnc | G52 needs X, Y or Z (value G52); add one
