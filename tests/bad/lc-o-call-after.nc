o1 sub
o1 endsub
o1 call [1] 2
m2
; expect after-o-word 3:13 linuxcnc | nothing may follow call (value 2); write it on a line of its own
