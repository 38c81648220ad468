m98 p7
m2
; expect no-subroutine 2:1 linuxcnc | there is no subroutine o<7>; define it, or put its file beside the program
