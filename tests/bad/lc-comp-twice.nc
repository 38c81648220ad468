G21 G90 G0 X0 Y0 Z0 F100
G41.1 D2
G1 X10
G41.1 D1
M2
; expect compensation 4:1 linuxcnc | the tool is compensated already (value G41.1); write G40 before
