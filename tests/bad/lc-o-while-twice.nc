o1 while [0]
o1 endwhile
o1 while [0]
o1 endwhile
m2
; expect label-twice 3:1 linuxcnc | o1 is in line 1 of lc-o-while-twice.nc already (value o1 while); give one of the two another label
