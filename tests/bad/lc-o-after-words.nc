g0 x1
g0 x1 o1 if [0]
m2
; expect not-supported 2:7 linuxcnc | an O-word begins a line of a whole program, in dialects that have them: here it is not read (value O1); write the words with plain numbers
