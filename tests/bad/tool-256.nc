T256
; expect tool-number 1:1
