g0 x#<nope>
m2
; expect unknown-parameter 1:5 linuxcnc | #<nope> has no value here (value #<NOPE>); assign it before
