G0 X0 Y0 Z0 F100
G2 Z1 I5
; expect arc-plane 2:1
