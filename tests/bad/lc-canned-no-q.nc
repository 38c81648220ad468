G21 G90 G0 X0 Y0 Z10 F100
X1 G83 Z-5 R2
; expect missing-word 2:4 linuxcnc
