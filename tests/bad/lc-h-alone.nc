G21 G90 G0 X0 Y0 Z0 F100
H1
M2
; expect unused-word 2:1 linuxcnc | no code on this line uses the word H (value H1); take it out or add its code
