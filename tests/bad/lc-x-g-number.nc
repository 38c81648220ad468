g[1.05] x1
m2
; expect unknown-code 1:1 linuxcnc | a G code has one decimal at most (value G[1.05]); correct the number
