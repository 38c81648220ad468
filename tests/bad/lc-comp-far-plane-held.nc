G21 G90 G0 X0 Y0 Z0 F100
G41.1 D2
G1 X10
G18.1
G40
G1 X11
M2
; expect compensation 4:1 linuxcnc | the plane may not be changed while the tool is compensated (value G18.1); write G40 before
