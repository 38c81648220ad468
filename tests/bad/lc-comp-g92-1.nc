G41.1 D2 G92.1
M2
; expect compensation 1:10 linuxcnc | axis offsets may not be changed while the tool is compensated (value G92.1); write G40 before
