M03 S100 #
; expect unknown-word 1:5 mini-lathe | mini-lathe B has no word S (value S100); the spindle's speed is set by hand
