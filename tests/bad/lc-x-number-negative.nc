g0 x#-1
m2
; expect parameter-range 1:5 linuxcnc | there is no parameter #-1 (value #-1); correct the number
