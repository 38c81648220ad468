G21 G90 G0 X0 Y0 Z0 F100
M3 S100
G33.1 Z-5 K1
Z-9
M2
; expect missing-word 4:1 linuxcnc | G33.1 needs a K word (value Z-9); add K
