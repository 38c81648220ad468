G0 X1 Y2 X3
; expect repeated-word 1:10
