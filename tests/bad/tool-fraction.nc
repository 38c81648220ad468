T1.5
; expect tool-number 1:1
