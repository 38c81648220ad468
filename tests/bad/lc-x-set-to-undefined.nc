#1=#<b>
m2
; expect unknown-parameter 1:4 linuxcnc | #<b> has no value here (value #<B>); assign it before
