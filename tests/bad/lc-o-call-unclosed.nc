o1 sub
o1 endsub
o1 call [1
m2
; expect bracket 3:9 linuxcnc | the expression is not closed (value [1); close it with ]
