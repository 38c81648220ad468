m98 p7.5
m2
o7
m99
; expect not-whole 1:6 linuxcnc | 7.5 stands where a whole number must (value 7.5); use ROUND[...]
