G21 G90 G0 X0 Y0 Z0 F100
G96 M3
M2
; expect missing-word 2:1 linuxcnc | G96 needs a S word (value G96); add S
