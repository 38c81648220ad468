g0 x#5602
m2
; expect parameter-range 1:5 linuxcnc | there is no parameter #5602 (value #5602); correct the number
