o1 if [1]
o1 continue
o1 endif
m2
; expect no-label 2:1 linuxcnc | continue has no while or do with the label o1 before it (value o1 continue); write one before it, or correct the label
