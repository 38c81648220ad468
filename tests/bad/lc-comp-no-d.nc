G21 G90 G0 X0 Y0 Z0 F100
G41.1
M2
; expect missing-word 2:1 linuxcnc | G41.1 needs a D word (value G41.1); add D
