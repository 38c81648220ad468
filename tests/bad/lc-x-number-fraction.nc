g0 x#1.5
m2
; expect not-whole 1:6 linuxcnc | 1.5 stands where a whole number must (value 1.5); use ROUND[...]
