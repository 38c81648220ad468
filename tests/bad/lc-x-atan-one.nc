g0 x[atan[1]]
m2
; expect function 1:6 linuxcnc | ATAN needs a second value (value ATAN[1]); write ATAN[y]/[x]
