G21 G90 G0 X0 Y0 Z0 F100
M3 S100
G76 Z-10 P1 I1 J.1 K1 A5
M2
; expect axis-unused 3:1 linuxcnc | G76 moves X and Z only (value G76); move other axes before
