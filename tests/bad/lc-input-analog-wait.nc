G21 G90 G0 X0 Y0 Z0 F100
M66 E1 L3 Q2
M2
; expect bad-value 2:8 linuxcnc | an analogue input is only read, with L0 (value L3); drop L
