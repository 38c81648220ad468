o1 else
m2
; expect no-label 1:1 linuxcnc | else has no if with the label o1 before it (value o1 else); write one before it, or correct the label
