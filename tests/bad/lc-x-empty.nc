g0 x[]
m2
; expect bad-number 1:6 linuxcnc | a value is missing (value ]); write a number, #parameter or [expression]
