G21 G0 X0 Y0 Z0
G5.2 X1 Y2 P1
M2
; expect no-feed 2:1 linuxcnc | G5.2 has no feed (value G5.2); write an F word above 0 before
