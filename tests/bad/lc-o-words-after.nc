o1 if [0] g0 x1
o1 endif
m2
; expect after-o-word 1:11 linuxcnc | nothing may follow if (value G0X1); write it on a line of its own
