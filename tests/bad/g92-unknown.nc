G92 X0
; expect unknown-position 1:5
