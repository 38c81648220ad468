f[0-5]
m2
; expect bad-value 1:1 linuxcnc | F may not be negative (value F-5); correct F
