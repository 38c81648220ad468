G21 G90 G0 X0 Y0 Z0 F100
M48 M50
M2
; expect modal-conflict 2:5 linuxcnc | M48 and M50 may not share a line: they set the same mode (value M50); write them on two lines
