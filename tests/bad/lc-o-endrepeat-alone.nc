o1 endrepeat
m2
; expect no-label 1:1 linuxcnc | endrepeat has no repeat with the label o1 before it (value o1 endrepeat); write one before it, or correct the label
