G21 G90 G0 X0 Y0 Z0 F100
S-1
M2
; expect bad-value 2:1 linuxcnc | S may not be negative (value S-1); correct S
