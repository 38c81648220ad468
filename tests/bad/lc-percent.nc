G0 X1
%
M2
; expect misplaced 2:1 linuxcnc
