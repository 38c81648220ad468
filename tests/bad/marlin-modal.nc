G1 X1 F100
X2
; expect no-motion 2:1 marlin | coordinates alone may not follow G1 (value X2); write the motion word again
