G00 X1. # Z2.
; expect record-end 1:11 mini-lathe | the record does not end (value Z2., limit #); end it with #
