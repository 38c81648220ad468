g0 x[sin 30]
m2
; expect bracket 1:10 linuxcnc | an expression begins with [ (value 30]); put it in brackets
