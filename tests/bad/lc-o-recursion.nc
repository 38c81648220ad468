o1 sub
o1 call
o1 endsub
o1 call
m2
; expect too-many-calls 2:1 linuxcnc | subroutines call each other too deep (value o1 call, limit 9); let fewer of them call each other
