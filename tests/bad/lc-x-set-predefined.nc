#<_x>=1
m2
; expect read-only 1:1 linuxcnc | #<_x> may not be assigned (value #<_X>); use a name of your own
