#<a=1
m2
; expect parameter 1:2 linuxcnc | the name is not closed (value <); close it with >
