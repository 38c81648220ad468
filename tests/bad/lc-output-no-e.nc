G21 G90 G0 X0 Y0 Z0 F100
M67 Q1
M2
; expect missing-word 2:1 linuxcnc | M67 needs a E word (value M67); add E
