G0 X1 Ü2
; expect unknown-character 1:7
