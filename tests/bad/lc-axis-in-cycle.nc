G21 G90 G0 X0 Y0 Z0 F100
G81 X1 A1 Z-1 R1
M2
; expect unused-word 2:8 linuxcnc | a canned cycle moves X, Y and Z only (value A1); move A on a line of its own
