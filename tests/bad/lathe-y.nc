G00 Y1. #
; expect unknown-word 1:5 mini-lathe | mini-lathe B has no word Y (value Y1., limit F, N, X, Z); the axes are X (radial) and Z (axial)
