G0 X1 !
; expect misplaced 1:7
