G21 G90 G0 X0 Y0 Z0 F100
G41.1 D2
G1 X10
G3 X10 Y1 I0 J.5
M2
; expect arc-radius 4:4 linuxcnc | the arc's radius is not larger than the tool's (value X10, limit more than 1 mm); use a smaller tool
