g0 x[1 (a) #2]
m2
; expect operator 1:12 linuxcnc | an operator is missing or unknown (value #2]); use + - * / ** MOD EQ NE GT GE LT LE AND OR XOR
