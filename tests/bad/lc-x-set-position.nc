#5420=1
m2
; expect read-only 1:1 linuxcnc | #5420 may not be assigned (value #5420); use a name of your own
