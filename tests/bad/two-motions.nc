G0 X1
G0 G1 X2 F100
; expect modal-conflict 2:4
