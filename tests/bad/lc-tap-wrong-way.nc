G21 G90 G0 X0 Y0 Z0 F100
S100 M4
G84 X1 Z-1 R1
M2
; expect spindle-stopped 3:1 linuxcnc | G84 needs the spindle to turn clockwise (M3) (value G84); write M3 before
