#5400=1
m2
; expect read-only 1:1 linuxcnc | #5400 may not be assigned (value #5400); use a name of your own
