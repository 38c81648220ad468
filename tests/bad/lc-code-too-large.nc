G21 G90 G0 X0 Y0 Z0 F100
M200
M2
; expect unknown-code 2:1 linuxcnc | LinuxCNC does not accept M200 (value M200); take it out
