#<_line>=1
m2
; expect read-only 1:1 linuxcnc | #<_line> may not be assigned (value #<_LINE>); use a name of your own
