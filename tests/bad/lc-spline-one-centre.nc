G21 G90 G0 X0 Y0 Z0 F100
G5.1 X1 Y1 I1
M2
; expect missing-word 2:1 linuxcnc | G5.1 needs both I and J (value G5.1); add them
