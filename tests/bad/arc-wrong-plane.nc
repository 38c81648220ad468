G0 X0 Y0 Z0 F100
G2 X10 K5
; expect unused-word 2:8
