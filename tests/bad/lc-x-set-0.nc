#0=1
m2
; expect parameter-range 1:1 linuxcnc | there is no parameter #0 (value #0); correct the number
