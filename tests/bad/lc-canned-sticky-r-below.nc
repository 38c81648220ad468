G21 G90 G0 X0 Y0 Z10 F100
G81 X1 Z-5 R2
X2 Z3
; expect retract-low 3:1 linuxcnc
