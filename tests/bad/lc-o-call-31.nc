o1 sub
o1 endsub
o1 call [1] [1] [1] [1] [1] [1] [1] [1] [1] [1] [1] [1] [1] [1] [1] [1] [1] [1] [1] [1] [1] [1] [1] [1] [1] [1] [1] [1] [1] [1] [1]
m2
; expect too-many-arguments 3:129 linuxcnc | a subroutine takes 30 arguments at most (value [1]); put some in named parameters
