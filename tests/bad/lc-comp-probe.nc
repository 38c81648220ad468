G21 G90 G0 X0 Y0 Z0 F100
G41.1 D2
G1 X10
G38.2 X1
M2
; expect compensation 4:1 linuxcnc | nothing may be probed while the tool is compensated (value G38.2); write G40 before
