G21 G90 G0 X0 Y0 Z0 F100
S100 M3
G74 X1 Z-1 R1
M2
; expect spindle-stopped 3:1 linuxcnc | G74 needs the spindle to turn counter-clockwise (M4) (value G74); write M4 before
