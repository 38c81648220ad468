G21 G90 G0 X0 Y0 Z0 F100
G95 G93 G1 X1 F1
M2
; expect modal-conflict 2:5 linuxcnc | G95 and G93 may not share a line: they set the same mode (value G93); write them on two lines
