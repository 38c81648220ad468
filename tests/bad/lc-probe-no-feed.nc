G21 G0 X0 Y0 Z0
G38.2 X1
M2
; expect no-feed 2:1 linuxcnc | G38.2 has no feed (value G38.2); write an F word above 0 before
