G0 X0 Y0
G2 X0 Y0 I5 P2 F100
; expect unused-word 2:13 marlin | no code on this line uses the word P (value P2); take it out or add its code
