G21 G90 G0 X0 Y0 Z0 F100
G89 X1 Z-1 R1
M2
; expect missing-word 2:1 linuxcnc | G89 needs a P word: none is in force (value G89); add P
