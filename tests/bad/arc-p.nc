G0 X0 Y0 F100
G2 X0 I4 P2
; expect unused-word 2:10
