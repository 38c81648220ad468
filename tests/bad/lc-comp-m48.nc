G21 G90 G0 X0 Y0 Z0 F100
G41.1 D2
G1 X10
M48
M2
; expect compensation 4:1 linuxcnc | overrides may not be switched while the tool is compensated (value M48); write G40 before
