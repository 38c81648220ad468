g0 x[1.2.3]
m2
; expect bad-number 1:6 linuxcnc | 1.2.3 is no number (value 1.2.3]); write a number, #parameter or [expression]
