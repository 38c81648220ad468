g0 x[exp[1000]]
m2
; expect domain 1:6 linuxcnc | EXP has no value for 1000 (value EXP[1000]); correct the expression
