G21 G90 G0 X0 Y0 Z0 F100
G28 @5 ^3
M2
; expect unused-word 2:5 linuxcnc | no code on this line uses the word @ (value @5); take it out or add its code
