G43 H1
; expect refused-code 1:1
