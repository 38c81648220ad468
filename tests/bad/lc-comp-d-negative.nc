G21 G90 G0 X0 Y0 Z0 F100
G41 D-1
M2
; expect bad-value 2:5 linuxcnc | D of G41 is the number of a tool (value D-1, limit a whole number from 0); correct D
