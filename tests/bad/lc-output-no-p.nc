G21 G90 G0 X0 Y0 Z0 F100
M62
M2
; expect missing-word 2:1 linuxcnc | M62 needs a P word (value M62); add P
