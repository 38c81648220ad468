G0 N10 X5
; expect line-number 1:4 iso | the N word must be the first of its line (value N10); write it first, or leave it out
