G21 G90 G0 X0 Y0 Z10 F100
G83 X1 Z-5 R2 Q.000001
; expect pecks-many 2:15 linuxcnc
