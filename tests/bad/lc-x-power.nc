g0 x[[0-2]**0.5]
m2
; expect not-finite 1:5 linuxcnc | -2 ** 0.5 is no finite number (value [[0-2]**0.5]); correct the expression
