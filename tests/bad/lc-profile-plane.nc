G21 G90 G0 X0 Y0 Z0 F100
o100 sub
G1 X5 Z-5
X6 Z-9
o100 endsub
G71 Q100 X9 Z1
M2
; expect plane 6:1 linuxcnc | G71 works in the plane ZX (value G71); write G18 before
