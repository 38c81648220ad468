g0 x[atan[1]/1]
m2
; expect bracket 1:14 linuxcnc | an expression begins with [ (value 1]); put it in brackets
