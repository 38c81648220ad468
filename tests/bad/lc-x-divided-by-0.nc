g0 x[1/0]
m2
; expect divided-by-zero 1:5 linuxcnc | the expression divides by 0 (value [1/0]); correct the expression
