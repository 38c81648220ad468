g0 x#
m2
; expect bad-number 1:5 linuxcnc | a value is missing; write a number, #parameter or [expression]
