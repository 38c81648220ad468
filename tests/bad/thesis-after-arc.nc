G0 X10 Y0
G3 X0 Y10 I0 J0
X5
; expect no-motion 3:1 thesis-a
