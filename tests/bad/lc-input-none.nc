G21 G90 G0 X0 Y0 Z0 F100
M66
M2
; expect input-words 2:1 linuxcnc | M66 takes either P, a digital input, or E, an analogue one (value M66); write one of them
