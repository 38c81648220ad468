o1 endwhile
m2
; expect no-label 1:1 linuxcnc | endwhile has no while with the label o1 before it (value o1 endwhile); write one before it, or correct the label
