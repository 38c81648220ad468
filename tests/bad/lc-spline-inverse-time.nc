G21 G90 G0 X0 Y0 Z0 F100
G93 G5.1 X1 Y1 I1 J1
M2
; expect feed-mode 2:5 linuxcnc | no spline is cut in inverse time (value G5.1); write G94 and an F word before
