o1 if 1
o1 endif
m2
; expect bracket 1:7 linuxcnc | [ is missing after if (value 1); write if [condition]
