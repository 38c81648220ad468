G81 X1 Z-5 R2 F50
; expect not-supported 1:1
