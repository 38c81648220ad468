#1=5
; expect not-supported 1:1
