G21 G90 G0 X0 Y0 Z0 F100
M3 M19
M2
; expect modal-conflict 2:4 linuxcnc | M3 and M19 may not share a line: they set the same mode (value M19); write them on two lines
