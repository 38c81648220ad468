g0 x#1.5
m2
; expect not-whole 1:6 linuxcnc | 1.5 must be a whole number (value 1.5); use ROUND[...]
