g0 x[1]]
m2
; expect unknown-character 1:8 linuxcnc | a word is a letter and a number (value ]); take it out
