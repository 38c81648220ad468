G00 X1. #
G71 #
X1. #
; expect no-motion 3:1 mini-lathe | there is no motion that the coordinates could belong to (value X1., limit G0, G1); write the motion word again
