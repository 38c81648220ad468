G21 G90 G0 X0 Y0 Z0 F100
G10 L1 P9 Z5
M2
; expect tool-length 2:8 linuxcnc | tool 9 is not in the tool table (value P9); give the tool with the start state
