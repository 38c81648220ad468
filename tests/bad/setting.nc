$100=80
; expect misplaced 1:1
