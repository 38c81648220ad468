o1 sub
g0 x1
g1 y#1
o1 endsub
f0
o1 call [5]
m2
; expect no-feed 3:1 linuxcnc | G1 has no feed (value G1); write an F word above 0 before
