g0 x[sqrt[-1]]
m2
; expect domain 1:6 linuxcnc | SQRT has no value for -1 (value SQRT[-1]); correct the expression
