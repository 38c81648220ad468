o1 if [0]
o1 if [0]
o1 endif
m2
; expect label-twice 2:1 linuxcnc | o1 is in line 1 of lc-o-label-twice-nested.nc already (value o1 if); give one of the two another label
