o1 sub
g0 x1
m2
; expect no-o-end 3:1 linuxcnc | o1 has no end: the text is over, and it is still being skipped; write its endif, endwhile, endrepeat, while or endsub
