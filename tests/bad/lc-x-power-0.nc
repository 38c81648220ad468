g0 x[0**[0-1]]
m2
; expect not-finite 1:5 linuxcnc | 0 ** -1 is no finite number (value [0**[0-1]]); correct the expression
