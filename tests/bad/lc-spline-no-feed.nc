G21 G90 G0 X0 Y0 Z0
G5.1 X1 Y1 I1 J1
M2
; expect no-feed 2:1 linuxcnc | G5.1 has no feed (value G5.1); write an F word above 0 before
