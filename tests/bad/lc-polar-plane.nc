G21 G90 G0 X0 Y0 Z0 F100
G18
G0 @5 ^60
M2
; expect polar 3:4 linuxcnc | @ and ^ lie in the plane XY (value @5); write G17 on a line before
