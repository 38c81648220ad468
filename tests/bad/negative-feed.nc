G1 X10 F-5
; expect bad-value 1:8
