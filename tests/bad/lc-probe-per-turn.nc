G21 G90 G0 X0 Y0 Z0 F100
G95 S100 F1 G38.2 X5
M2
; expect feed-mode 2:13 linuxcnc | a probe takes no feed per turn (value G38.2); write G94 before
