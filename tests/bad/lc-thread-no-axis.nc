G21 G90 G0 X0 Y0 Z0 F100
M3 S100
G33 K1
M2
; expect missing-axis 3:1 linuxcnc | G33 needs X, Y or Z (value G33); add one
