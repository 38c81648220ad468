G21 G90 G0 X0 Y0 Z0 F100
G0 @5
M2
; expect polar 2:4 linuxcnc | the angle is not known at the zero of the work system (value @5); give ^ with G90
