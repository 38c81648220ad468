g0 x[foo[1]]
m2
; expect function 1:6 linuxcnc | there is no function FOO (value F); use ABS, ACOS, ASIN, COS, EXP, FIX, FUP, LN, ROUND, SIN, SQRT, TAN or ATAN
