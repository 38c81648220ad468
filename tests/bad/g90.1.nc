G90.1
; expect refused-code 1:1
