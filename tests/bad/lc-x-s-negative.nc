s[0-5]
m2
; expect bad-value 1:1 linuxcnc | S may not be negative (value S-5); correct S
