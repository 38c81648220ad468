G21 G90 G0 X0 Y0 Z0 F100
G41.1 D2
G1 X10
G5.3
M2
; expect no-spline 4:1 linuxcnc | G5.3 without a G5.2 before it (value G5.3); write G5.2 before
