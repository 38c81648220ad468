#<width>=5 G0 X#<width>
M2
; expect unknown-parameter 1:16 linuxcnc | #<width> has no value here (value #<WIDTH>); assign it before
