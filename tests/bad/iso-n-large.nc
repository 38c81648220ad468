N10000 G0 X5
; expect line-number 1:1 iso | the line number is out of range (value N10000, limit 0 to 9999); write a number within the limit, or leave N out
