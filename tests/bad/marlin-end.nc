G0 X1
M30
; expect refused-code 2:1 marlin | Marlin does not accept M30 (value M30); Marlin has no end word (M30 deletes a file): leave it out
