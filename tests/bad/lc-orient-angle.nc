G21 G90 G0 X0 Y0 Z0 F100
M19 R400
M2
; expect bad-value 2:5 linuxcnc | R is out of range (value R400, limit 0 to 360); correct R
