n[5] g0 x1
m2
; expect line-number 1:1 linuxcnc | a line number is written in digits (value N); write N10
