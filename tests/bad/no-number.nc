G0 X
; expect bad-number 1:4
