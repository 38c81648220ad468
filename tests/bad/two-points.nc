G0 X1.2.3
; expect bad-number 1:8
