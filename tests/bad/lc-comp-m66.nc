G21 G90 G0 X0 Y0 Z0 F100
G41.1 D2
G1 X10
M66 P1 L0
M2
; expect compensation 4:1 linuxcnc | no input may be read while the tool is compensated (value M66); write G40 before
