G81 X1 Z-5 R2 F50
; expect refused-code 1:1
