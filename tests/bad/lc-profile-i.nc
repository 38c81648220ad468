G21 G90 G0 X0 Y0 Z0 F100
G18
o100 sub
G1 X5 Z0
Z-5
o100 endsub
G71 Q100 X9 Z1 I0
M2
; expect bad-value 7:16 linuxcnc | I of G71 must be above 0 (value I0); correct I
