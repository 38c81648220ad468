G21 G90 G0 X0 Y0 Z0 F100
M70 M3
M2
; expect modal-conflict 2:5 linuxcnc | M70 and M3 may not share a line: they set the same mode (value M3); write them on two lines
