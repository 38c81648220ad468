G21 G90 G0 X0 Y0 Z0 F100
D5
M2
; expect unused-word 2:1 linuxcnc | no code on this line uses the word D (value D5); take it out or add its code
