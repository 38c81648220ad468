X5
; expect no-motion 1:1 thesis-a
