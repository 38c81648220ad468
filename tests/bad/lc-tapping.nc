G21 G90 G0 X0 Y0 Z10 F100
G84 X1 Z-5 R2
; expect spindle-stopped 2:1 linuxcnc
