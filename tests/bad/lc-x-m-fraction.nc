m[3.5]
m2
; expect unknown-code 1:1 linuxcnc | LinuxCNC does not accept M3.5 (value M3.5); take it out
