G21 G90 G0 X0 Y0 Z0 F100
G18
o100 sub
G1 X5 Z0
G2 Z-5
o100 endsub
G71 Q100 X9 Z1
M2
; expect arc-words 5:10 linuxcnc | the arc has neither I nor K nor R (value X9); give its centre
