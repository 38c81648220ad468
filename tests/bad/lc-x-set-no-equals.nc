#1 5
m2
; expect assignment 1:1 linuxcnc | = is missing after the parameter (value #15); write #1=2
