o1 sub
g0 x#<a>
o1 endsub
#<a>=1
o1 call
m2
; expect unknown-parameter 2:5 linuxcnc | #<a> has no value here (value #<A>); assign it before
