g0 x[1+]
m2
; expect bad-number 1:8 linuxcnc | a value is missing (value ]); write a number, #parameter or [expression]
