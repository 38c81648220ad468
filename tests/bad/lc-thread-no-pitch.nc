G21 G90 G0 X0 Y0 Z0 F100
M3 S100
G33 Z-5
M2
; expect missing-word 3:1 linuxcnc | G33 needs a K word (value G33); add K
