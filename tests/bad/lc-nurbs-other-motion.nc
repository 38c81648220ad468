G21 G90 G0 X0 Y0 Z0 F100
G5.2 P1 X0 Y1
G1 X5
G5.3
M2
; expect no-spline 4:1 linuxcnc | G5.3 without a G5.2 before it (value G5.3); write G5.2 before
