G21 G90 G0 X0 Y0 Z0 F100
G5 X1 Y1 I1 J1
M2
; expect missing-word 2:1 linuxcnc | G5 needs both P and Q (value G5); add them
