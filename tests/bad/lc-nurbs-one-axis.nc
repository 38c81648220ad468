G21 G90 G0 X0 Y0 Z0 F100
G5.2 X1
M2
; expect missing-word 2:1 linuxcnc | a control point needs both X and Y (value G5.2); add the other
