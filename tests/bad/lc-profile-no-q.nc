G21 G90 G0 X0 Y0 Z0 F100
G18
G71 X1
M2
; expect missing-word 3:1 linuxcnc | G71 needs a Q word (value G71); add Q
