G1 X10 F0
; expect no-feed 1:1
