g0 x[exists[#<a>]
m2
; expect bracket 1:5 linuxcnc | the expression is not closed (value [EXISTS[#<A>]); close it with ]
