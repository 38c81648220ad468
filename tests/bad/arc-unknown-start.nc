G21 F100
G2 X10 Y0 I5
; expect unknown-position 2:4
