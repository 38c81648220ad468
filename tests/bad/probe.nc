G38.2 Z-5 F50
; expect not-supported 1:1
