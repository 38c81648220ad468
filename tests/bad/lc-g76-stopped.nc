G21 G90 G0 X0 Y0 Z0 F100
G76 Z-10 P1 I1 J.1 K1
M2
; expect spindle-stopped 2:1 linuxcnc | G76 needs the spindle to turn (value G76); write M3 before
