G91 G0 X5
; expect unknown-position 1:8
