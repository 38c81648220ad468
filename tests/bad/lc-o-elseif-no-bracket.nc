o1 if [0]
o1 elseif 1
o1 endif
m2
; expect bracket 2:11 linuxcnc | [ is missing after elseif (value 1); write elseif [condition]
