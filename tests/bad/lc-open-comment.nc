G0 X1 (open
M2
; expect comment 1:7 linuxcnc
