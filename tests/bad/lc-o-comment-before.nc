(c) o1 if [0]
o1 endif
m2
; expect not-supported 1:5 linuxcnc | an O-word begins a line of a whole program, in dialects that have them: here it is not read (value O1); write the words with plain numbers
