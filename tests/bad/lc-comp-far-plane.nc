G41.1 D2
G18.1
G0 X9
M2
; expect compensation 3:1 linuxcnc | nothing moves in the plane G18.1 while the tool is compensated (value G0); write G40 before
