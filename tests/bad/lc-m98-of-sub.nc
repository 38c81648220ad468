m98 p7
m2
o7 sub
o7 endsub
; expect wrong-call 3:1 linuxcnc | o<name> sub is called by o<name> call (value o7 sub); correct the call
