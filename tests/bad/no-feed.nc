G21
G0 X0
G1 X10
; expect no-feed 3:1
