G21 G90 G0 X0 Y0 Z0 F100
G38.2
M2
; expect missing-axis 2:1 linuxcnc | G38.2 needs X, Y or Z (value G38.2); add one
