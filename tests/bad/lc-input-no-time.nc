G21 G90 G0 X0 Y0 Z0 F100
M66 P1 L3
M2
; expect missing-word 2:8 linuxcnc | M66 with L waits: it needs Q above 0 (value L3); add Q
