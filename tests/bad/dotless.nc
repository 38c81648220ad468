G0 X1 Y1
G0 X2 ı5
; expect unknown-character 2:7
