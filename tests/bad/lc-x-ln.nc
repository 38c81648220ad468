g0 x[ln[0]]
m2
; expect domain 1:6 linuxcnc | LN has no value for 0 (value LN[0]); correct the expression
