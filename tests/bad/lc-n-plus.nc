G0 X0
N+5 X1
M2
; expect line-number 2:1 linuxcnc | a line number begins with a digit (value N+5); write N10
