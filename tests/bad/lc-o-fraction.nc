o1.5 if [1]
o1 endif
m2
; expect not-whole 1:2 linuxcnc | 1.5 must be a whole number (value 1.5); use ROUND[...]
