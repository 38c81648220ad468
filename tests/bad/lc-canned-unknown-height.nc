G21 G90 F100
G81 X1 Y1 Z-5 R2
; expect unknown-position 2:11 linuxcnc
