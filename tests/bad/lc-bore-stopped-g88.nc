G21 G90 G0 X0 Y0 Z0 F100
G88 X2 Z-1 R1 P1
M2
; expect spindle-stopped 2:1 linuxcnc | G88 needs the spindle to turn (value G88); write M3 before
