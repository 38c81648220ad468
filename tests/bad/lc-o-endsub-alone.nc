o1 endsub
m2
; expect not-in-sub 1:1 linuxcnc | endsub is outside any subroutine (value o1 endsub); take it out, or end with M2
