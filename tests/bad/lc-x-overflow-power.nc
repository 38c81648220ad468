g0 x[10**1000]
m2
; expect not-finite 1:5 linuxcnc | 10 ** 1000 is no finite number (value [10**1000]); correct the expression
