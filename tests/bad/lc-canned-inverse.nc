G21 G90 G0 X0 Y0 Z10 F100
G93 F2 G81 X1 Z-5 R2
; expect feed-mode 2:8 linuxcnc
