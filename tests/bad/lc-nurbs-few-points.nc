G21 G90 G0 X0 Y0 Z0 F100
G5.2 P1
X2 Y1 P1 L4
G5.3
M2
; expect control-points 4:1 linuxcnc | a NURBS of order 4 needs as many control points (value G5.3, limit 4); add control points
