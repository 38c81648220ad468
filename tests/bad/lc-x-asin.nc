g0 x[asin[-1.01]]
m2
; expect domain 1:6 linuxcnc | ASIN has no value for -1.01 (value ASIN[-1.01]); correct the expression
