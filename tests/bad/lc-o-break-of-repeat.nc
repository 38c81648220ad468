o1 repeat [3]
o1 break
o1 endrepeat
m2
; expect no-label 2:1 linuxcnc | break has no while or do with the label o1 before it (value o1 break); write one before it, or correct the label
