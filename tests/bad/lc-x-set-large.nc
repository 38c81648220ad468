#5602=1
m2
; expect parameter-range 1:1 linuxcnc | there is no parameter #5602 (value #5602); correct the number
