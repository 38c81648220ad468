G0 X0 Y0 Z0
G93
G1 X5
; expect no-feed 3:1
