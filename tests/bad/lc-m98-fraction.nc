m98 p7.5
m2
o7
m99
; expect not-whole 1:6 linuxcnc | 7.5 must be a whole number (value 7.5); use ROUND[...]
