G21 G90 G0 X0 Y0 Z0 F100
G43.2
M2
; expect missing-word 2:1 linuxcnc | G43.2 needs a H word (value G43.2); add H
