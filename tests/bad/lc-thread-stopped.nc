G21 G90 G0 X0 Y0 Z0 F100
G33 Z-5 K1
M2
; expect spindle-stopped 2:1 linuxcnc | G33 needs the spindle to turn (value G33); write M3 before
