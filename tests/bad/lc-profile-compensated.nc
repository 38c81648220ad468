G21 G90 G0 X0 Y0 Z0 F100
G18
o100 sub
G1 X5 Z0
Z-5
o100 endsub
G41.1 D1
G71 Q100 X9 Z1
M2
; expect compensation 8:1 linuxcnc | G71 may not be used while the tool is compensated (value G71); write G40 before
