o1 call
m2
o1 sub
g0 x1
; expect no-endsub 4:1 linuxcnc | the subroutine o<1> has no end; write endsub, or M99 in a subprogram of Fanuc's form
