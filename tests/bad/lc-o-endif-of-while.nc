o1 while [1]
o1 endif
m2
; expect no-label 2:1 linuxcnc | endif has no if with the label o1 before it (value o1 endif); write one before it, or correct the label
