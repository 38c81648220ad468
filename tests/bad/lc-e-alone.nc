G21 G90 G0 X0 Y0 Z0 F100
E1
M2
; expect unused-word 2:1 linuxcnc | no code on this line uses the word E (value E1); take it out or add its code
