G21 G90 G0 X0 Y0 Z0 F100
M72
M2
; expect no-modes 2:1 linuxcnc | no modes are kept here (value M72); write M70 before, in the same subroutine
