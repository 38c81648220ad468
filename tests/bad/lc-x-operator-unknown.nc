g0 x[1 nand 2]
m2
; expect operator 1:8 linuxcnc | an operator is missing or unknown (value NAND2]); use + - * / ** MOD EQ NE GT GE LT LE AND OR XOR
