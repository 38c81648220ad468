g0 x[.]
m2
; expect bad-number 1:6 linuxcnc | . is no number (value .]); write a number, #parameter or [expression]
