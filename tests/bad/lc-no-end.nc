G0 X1
; expect no-end 1:0 linuxcnc
