=5
m2
; expect unknown-character 1:1 linuxcnc | a word is a letter and a number (value =5); take it out
