G21 G90
G0 X1
; expect several-commands 1:5 marlin | a line holds one command (value G9); write them on two lines
