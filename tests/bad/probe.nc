G38.2 Z-5 F50
; expect refused-code 1:1
