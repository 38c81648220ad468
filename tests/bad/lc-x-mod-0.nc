g0 x[1 mod 0]
m2
; expect not-finite 1:5 linuxcnc | 1 MOD 0 is no finite number (value [1MOD0]); correct the expression
