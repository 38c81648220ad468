o7 call
m2
o7
m99
; expect wrong-call 3:1 linuxcnc | O1234 is called by M98 P1234 (value o7); correct the call
