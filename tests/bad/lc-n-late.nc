G0 N5 X1
M2
; expect line-number 1:4 linuxcnc
