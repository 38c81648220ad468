G0 X1
G53
M2
; expect machine-move 2:1 linuxcnc | G53 needs a G0 or G1 move (value G53); add G0 or G1
