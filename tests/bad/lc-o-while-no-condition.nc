o1 while
o1 endwhile
m2
; expect bracket 1:8 linuxcnc | [ is missing after while; write while [condition]
