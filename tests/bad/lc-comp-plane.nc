G21 G90 G0 X0 Y0 Z0 F100
G19 G41.1 D1
M2
; expect plane 2:5 linuxcnc | the tool is compensated in the planes XY and ZX only (value G41.1); write G17 or G18 before
