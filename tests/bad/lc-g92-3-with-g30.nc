G21 G90 G0 X0 Y0 Z0
G92.3 G30 X2
M2
; expect modal-conflict 2:7 linuxcnc | G92.3 and G30 may not share a line: they set the same mode (value G30); write them on two lines
