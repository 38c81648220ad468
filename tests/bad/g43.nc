G43 H1
; expect unknown-word 1:5
