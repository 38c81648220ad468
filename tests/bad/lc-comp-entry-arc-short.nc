G21 G90 G0 X0 Y0 Z0 F100
G41.1 D20
G2 X10 I5
M2
; expect entry-short 3:4 linuxcnc | the entry arc of the compensation is not larger than the tool's radius (value X10, limit more than 10 mm); begin farther away
