G21 G90 G0 X0 Y0 Z0 F100
M100
M2
; expect unknown-code 2:1 linuxcnc | LinuxCNC does not accept M100 (value M100); set up a program of that name on the machine
