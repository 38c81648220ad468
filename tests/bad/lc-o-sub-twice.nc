o1 sub
o1 endsub
o1 sub
o1 endsub
m2
; expect label-twice 3:1 linuxcnc | o1 is in line 1 of lc-o-sub-twice.nc already (value o1 sub); give one of the two another label
