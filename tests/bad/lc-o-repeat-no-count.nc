o1 repeat
o1 endrepeat
m2
; expect bracket 1:9 linuxcnc | [ is missing after repeat; write repeat [condition]
