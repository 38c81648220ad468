g0 x[1+2
m2
; expect bracket 1:5 linuxcnc | the expression is not closed (value [1+2); close it with ]
