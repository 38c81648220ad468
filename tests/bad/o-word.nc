o100 sub
; expect not-supported 1:1
