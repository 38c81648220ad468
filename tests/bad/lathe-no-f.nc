G01 X1. #
; expect missing-word 1:1 mini-lathe | G1 needs a F word (value G01, limit F above 0); add F
