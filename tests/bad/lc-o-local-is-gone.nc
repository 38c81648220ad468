o1 sub
#<a>=1
o1 endsub
o1 call
g0 x#<a>
m2
; expect unknown-parameter 5:5 linuxcnc | #<a> has no value here (value #<A>); assign it before
