G28.1
; expect refused-code 1:1 mach | Mach3/4 does not accept G28.1 (value G28.1); G28.1 homes a Mach machine: home it before the program
