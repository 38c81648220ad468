o<nothing> call
m2
; expect no-subroutine 2:1 linuxcnc | there is no subroutine o<nothing>; define it, or put its file beside the program
