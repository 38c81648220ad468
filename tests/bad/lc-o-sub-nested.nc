o1 sub
o2 sub
o2 endsub
o1 endsub
m2
; expect nested-sub 2:1 linuxcnc | a subroutine may not be defined inside another one (value o2 sub); write it before or after the other one
