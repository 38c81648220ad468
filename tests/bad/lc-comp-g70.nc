G21 G90 G18 G0 X0 Y0 Z0 F100
o1 sub
G0 X5 Z0
G1 Z-5
G1 X12
o1 endsub
G0 X14 Z2
G42.1 D0
G70 Q1
M2
; expect compensation 9:1 linuxcnc | G70 may not be used while the tool is compensated (value G70); write G40 before
