m98 p7
m2
o7
g0 x1
; expect no-endsub 4:1 linuxcnc | the subroutine o<7> has no end; write endsub, or M99 in a subprogram of Fanuc's form
