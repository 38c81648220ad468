G21 G90 G0 X0 Y0 Z0 F100
G41.1 D2
G1 X10
M64 P1
M2
; expect compensation 4:1 linuxcnc | no output may be set while the tool is compensated (value M64); write G40 before
