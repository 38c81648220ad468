G21 G90 G0 X0 Y0 Z0 F100
G95 S100 F0 G1 X10
M2
; expect no-feed 2:13 linuxcnc | G1 has no feed: a feed per turn needs F and a spindle that turns (value G1); write F and S above 0 before
