g[1000] x1
m2
; expect unknown-code 1:1 linuxcnc | LinuxCNC does not accept G1000 (value G1000); take it out
