o1 return
m2
; expect not-in-sub 1:1 linuxcnc | return is outside any subroutine (value o1 return); take it out, or end with M2
