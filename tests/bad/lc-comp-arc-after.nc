G21 G90 G0 X0 Y0 Z0 F100
G41.1 D2
G1 X10
G40
G2 X20 I5
M2
; expect compensation 5:1 linuxcnc | the move after the end of a compensation must be a line (value G2); write a G0 or G1 before
