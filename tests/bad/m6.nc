T1
M6
; expect refused-code 2:1
