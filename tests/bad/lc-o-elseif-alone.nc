o1 elseif [1]
m2
; expect no-label 1:1 linuxcnc | elseif has no if with the label o1 before it (value o1 elseif); write one before it, or correct the label
