G21 G90 G0 X0 Y0 Z0 F100
M61
M2
; expect missing-word 2:1 linuxcnc | M61 needs a Q word (value M61); add Q
