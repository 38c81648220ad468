#1=o
m2
; expect function 1:4 linuxcnc | there is no function O (value O); use ABS, ACOS, ASIN, COS, EXP, FIX, FUP, LN, ROUND, SIN, SQRT, TAN or ATAN
