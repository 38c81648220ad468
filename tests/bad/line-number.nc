N10000000 G0 X1
; expect line-number 1:1
