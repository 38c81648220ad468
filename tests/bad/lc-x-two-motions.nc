g[0] g[1] x1
m2
; expect modal-conflict 1:6 linuxcnc | G0 and G1 may not share a line: they set the same mode (value G1); write them on two lines
