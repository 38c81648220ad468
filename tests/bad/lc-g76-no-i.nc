G21 G90 G0 X0 Y0 Z0 F100
M3 S100
G76 Z-10 P1 J.1 K1
M2
; expect missing-word 3:1 linuxcnc | G76 needs a I word (value G76); add I
