G21 G90 G0 X0 Y0 Z0 F100
G93 G5.1 X1 Y1 I1 J1
M2
; expect no-feed 2:5 linuxcnc | in inverse time every G5.1 needs its own F above 0 (value G5.1); add F, or write G94 before
