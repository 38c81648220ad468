G21 G90 G0 X0 Y0 Z0 F100
G38.2 X0
M2
; expect no-move 2:1 linuxcnc | the probe is at its target already (value G38.2); correct the end
