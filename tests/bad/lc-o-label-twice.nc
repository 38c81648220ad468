o1 if [1]
o1 endif
o1 if [1]
o1 endif
m2
; expect label-twice 3:1 linuxcnc | o1 is in line 1 of lc-o-label-twice.nc already (value o1 if); give one of the two another label
