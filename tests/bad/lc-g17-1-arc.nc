G21 G90 G0 X0 Y0 Z0 F100
G17.1 G2 X1 I1
M2
; expect plane 2:7 linuxcnc | G2 is not read in G17.1, a plane of the axes U, V and W (value G2); write G17, G18 or G19 before
