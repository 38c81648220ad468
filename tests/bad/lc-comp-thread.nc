G21 G90 G0 X0 Y0 Z0 F100
G41.1 D2
G1 X10
M3 S1 G33 Z-1 K1
M2
; expect compensation 4:7 linuxcnc | G33 may not be used while the tool is compensated (value G33); write G40 before
