G21 G90 G0 X0 Y0 Z10 F100
G81 X1 Z-5 R-6
; expect retract-low 2:12 linuxcnc
