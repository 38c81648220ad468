g0 x[exists[1]]
m2
; expect function 1:12 linuxcnc | EXISTS asks for a parameter (value [); write EXISTS[#<name>]
