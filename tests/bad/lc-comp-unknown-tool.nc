G21 G90 G0 X0 Y0 Z0 F100
G41 D9
M2
; expect tool-length 2:5 linuxcnc | tool 9 is not in the tool table (value D9); give the tool with the start state
