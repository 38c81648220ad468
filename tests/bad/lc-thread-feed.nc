G21 G90 G0 X0 Y0 Z0 F100
M3 S100
G33 Z-1 K1 F5
M2
; expect unused-word 3:12 linuxcnc | G33 takes no F: the spindle drives it (value F5); write F on a line of its own
