G61.1 Q-1
M2
; expect unused-word 1:7 linuxcnc | no code on this line uses the word Q (value Q-1); take it out or add its code
