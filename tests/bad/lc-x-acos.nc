g0 x[acos[2]]
m2
; expect domain 1:6 linuxcnc | ACOS has no value for 2 (value ACOS[2]); correct the expression
