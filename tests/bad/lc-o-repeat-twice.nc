o1 repeat [1]
o1 endrepeat
o1 repeat [1]
o1 endrepeat
m2
; expect label-twice 3:1 linuxcnc | o1 is in line 1 of lc-o-repeat-twice.nc already (value o1 repeat); give one of the two another label
