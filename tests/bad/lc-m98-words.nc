m98 p7 x1
m2
o7
m99
; expect unused-word 1:8 linuxcnc | M98 takes one P and one L (value X1); write it on a line of its own
