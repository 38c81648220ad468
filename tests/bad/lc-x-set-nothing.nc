#1=
m2
; expect bad-number 1:3 linuxcnc | a value is missing; write a number, #parameter or [expression]
