m98
m2
; expect missing-word 1:1 linuxcnc | M98 needs a P word (value M98); write M98 P1234
