G21 G90 G0 X0 Y0 Z0 F100
G18
o100 sub
G1 X5 Z0
Z-5
Z-2 X8
Z-10 X12
o100 endsub
G71 Q100 X14 Z1
M2
; expect profile 8:10 linuxcnc | the profile turns back along Z (value X14); let Z always rise or always fall
