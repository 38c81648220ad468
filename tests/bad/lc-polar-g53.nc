G21 G90 G0 X0 Y0 Z0 F100
G53 G0 @5 ^3
M2
; expect polar 2:1 linuxcnc | G53 takes X and Y only (value G53); write the end point itself
