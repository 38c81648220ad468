G0 X10 Y0
G2 X0 Y10 I0
; expect arc-words 2:1 thesis-a
