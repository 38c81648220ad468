G21 G90 G0 X0 Y0 Z0 F100
M3 $9
M2
; expect spindle-number 2:4 linuxcnc | the machine has one spindle, number 0 (value $9, limit 0 or -1); drop $
