G91 G53 G0 X1
M2
; expect machine-move 1:5 linuxcnc
