G21 G90 G0 X0 Y0 Z0 F100
G41.1 D2
G1 X1
M2
; expect entry-short 3:4 linuxcnc | the entry move of the compensation is not longer than the tool's radius (value X1, limit more than 1 mm); begin farther away
