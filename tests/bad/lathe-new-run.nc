G01 X1. F1. #
X1. #
G01 Z1. #
; expect missing-word 3:1 mini-lathe | G1 needs a F word (value G01, limit F above 0); add F
