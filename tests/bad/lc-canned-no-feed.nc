G21 G90 G0 X0 Y0 Z10
G81 X1 Z-5 R2
; expect no-feed 2:1 linuxcnc
