M03 S100 #
; expect refused-code 1:1 mini-lathe | mini-lathe B does not accept M3 (value M03); the spindle's speed is set by hand
