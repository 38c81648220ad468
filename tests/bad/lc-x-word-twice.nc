g0 x[1] x2
m2
; expect repeated-word 1:9 linuxcnc | X is twice on the line (value X2); write it once
