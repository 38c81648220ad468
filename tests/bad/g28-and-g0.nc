G0 G28 X1
; expect axis-conflict 1:4
