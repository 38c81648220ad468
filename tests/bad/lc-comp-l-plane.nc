G21 G90 G0 X0 Y0 Z0 F100
G41.1 D2 L1
M2
; expect plane 2:1 linuxcnc | a lathe tool is compensated in the plane ZX (value G41.1); write G18
