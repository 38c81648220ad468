G80
X5
; expect no-motion 2:1
