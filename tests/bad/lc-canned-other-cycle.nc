G21 G90 G0 X0 Y0 Z10 F100
G82 X1 Z-5 R2 P1
G81 X2
; expect missing-word 3:1 linuxcnc
