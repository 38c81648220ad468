n-5 g0 x1
m2
; expect line-number 1:1 linuxcnc | a line number begins with a digit (value N-5); write N10
