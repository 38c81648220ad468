G21 G90 G0 X0 Y0 Z0 F100
G86 X2 Z-1 R1 P1
M2
; expect spindle-stopped 2:1 linuxcnc | G86 needs the spindle to turn (value G86); write M3 before
