G0 X[1+2]
; expect not-supported 1:4
