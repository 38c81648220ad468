G21 G90 G0 X0 Y0 Z0 F100
T-1
M2
; expect tool-number 2:1 linuxcnc | T must be a whole number (value T-1, limit 0 to 2147483647); correct T
