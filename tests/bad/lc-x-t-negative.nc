t[0-1]
m2
; expect tool-number 1:1 linuxcnc | T must be a whole number (value T-1, limit 0 to 2147483647); correct T
