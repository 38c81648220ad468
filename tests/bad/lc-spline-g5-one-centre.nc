G21 G90 G0 X0 Y0 Z0 F100
G5 X1 Y1 I1 P1 Q1
M2
; expect missing-word 2:1 linuxcnc | G5 needs both I and J or neither (value G5); add them
