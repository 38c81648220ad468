G21 G90 G0 X0 Y0 Z0 F100
G1 U5
M2
; expect unknown-word 2:4 linuxcnc | LinuxCNC has no word U (value U5); the stand-alone interpreter moves X Y Z A B C only
