G21 G90 G0 X0 Y0 Z0 F100
M50 P1 $0
M2
; expect unused-word 2:8 linuxcnc | no code on this line uses the word $ (value $0); take it out or add its code
