G38.2 Z-1 F10
; expect refused-code 1:1 mach | Mach3/4 does not accept G38.2 (value G38.2); Mach probes with G31
