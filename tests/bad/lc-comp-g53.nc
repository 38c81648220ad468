G21 G90 G0 X0 Y0 Z0 F100
G41.1 D2
G1 X10
G53 G0 X1
M2
; expect compensation 4:1 linuxcnc | G53 may not be used while the tool is compensated (value G53); write G40 before
