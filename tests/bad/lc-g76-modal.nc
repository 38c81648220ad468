G21 G90 G0 X0 Y0 Z0 F100
M3 S100
G76 Z-10 P1 I1 J.5 K1
Z-20
M2
; expect missing-word 4:1 linuxcnc | G76 needs a P word (value Z-20); add P
