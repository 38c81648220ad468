G21 G90 G0 X0 Y0 Z0 F100
G0 X5 @5 ^1
M2
; expect polar 2:4 linuxcnc | @ and ^ stand for X and Y (value X5); take it out
