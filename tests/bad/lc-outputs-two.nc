G21 G90 G0 X0 Y0 Z0 F100
M62 P1 M64
M2
; expect modal-conflict 2:8 linuxcnc | M62 and M64 may not share a line: they set the same mode (value M64); write them on two lines
