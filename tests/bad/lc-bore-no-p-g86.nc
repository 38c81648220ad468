G21 G90 G0 X0 Y0 Z0 F100
S100 M3
G86 X1 Z-1 R1
M2
; expect missing-word 3:1 linuxcnc | G86 needs a P word: none is in force (value G86); add P
