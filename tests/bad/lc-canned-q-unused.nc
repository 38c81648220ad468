G21 G90 G0 X0 Y0 Z10 F100
G81 X1 Z-5 R2 Q1
; expect unused-word 2:15 linuxcnc
