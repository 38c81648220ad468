o1 if [1]
o2 endif
m2
; expect no-label 2:1 linuxcnc | endif has no if with the label o2 before it (value o2 endif); write one before it, or correct the label
