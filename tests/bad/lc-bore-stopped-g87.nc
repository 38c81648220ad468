G21 G90 G0 X0 Y0 Z0 F100
G87 X2 Z-1 R1 I1 J1 K1
M2
; expect spindle-stopped 2:1 linuxcnc | G87 needs the spindle to turn (value G87); write M3 before
