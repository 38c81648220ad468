G21 G90 G0 X0 Y0 Z0 F100
G5.1 X1 Y1 I1 J1 Z1
M2
; expect unused-word 2:18 linuxcnc | a spline moves X and Y only (value Z1); move Z on a line of its own
