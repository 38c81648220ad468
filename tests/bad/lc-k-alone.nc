G21 G90 G0 X0 Y0 Z0 F100
K1
M2
; expect unused-word 2:1 linuxcnc | no code on this line uses the word K (value K1); take it out or add its code
