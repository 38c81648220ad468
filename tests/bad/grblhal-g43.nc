G43 H1
; expect unknown-word 1:5 grblhal | grblHAL has no word H (value H1); take it out
