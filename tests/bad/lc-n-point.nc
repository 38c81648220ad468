N.5 G0 X1
M2
; expect line-number 1:1 linuxcnc | a line number begins with a digit (value N.5); write N10
