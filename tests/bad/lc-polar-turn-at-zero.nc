G21 G90 G0 X0 Y0 Z0 F100
G91 G0 ^30
M2
; expect polar 2:8 linuxcnc | the angle is not known at the zero of the work system (value ^30); give ^ with G90
