G21 G90 G0 X0 Y0 Z0 F100
S100 M3
G87 X1 Z-1 R1 I1 J1
M2
; expect missing-word 3:1 linuxcnc | G87 needs a K word: none is in force (value G87); add K
