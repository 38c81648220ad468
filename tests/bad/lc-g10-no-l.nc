G21 G90 G0 X0 Y0 Z0 F100
G10 P1 X1
M2
; expect missing-word 2:1 linuxcnc | G10 needs a L word (value G10); add L
