(a (b) c)
M2
; expect comment 1:4 linuxcnc
