o1 jump
m2
; expect o-word 1:4 linuxcnc | the O-word is unknown (value JUMP); use one of: sub, endsub, call, do, while, repeat, if, elseif, else, endif, break, continue, endwhile, endrepeat, return
