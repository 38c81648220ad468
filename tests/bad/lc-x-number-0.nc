g0 x#0
m2
; expect parameter-range 1:5 linuxcnc | there is no parameter #0 (value #0); correct the number
