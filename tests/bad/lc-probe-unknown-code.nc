G21 G90 G0 X0 Y0 Z0 F100
G38.6 X1
M2
; expect unknown-code 2:1 linuxcnc | LinuxCNC does not accept G38.6 (value G38.6); take it out
