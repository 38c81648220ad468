G0 X0 Y0 F100
G2 X10
; expect arc-words 2:1
