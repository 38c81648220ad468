G28 X0
; expect refused-code 1:1 marlin | Marlin does not accept G28 (value G28); G28 homes a Marlin machine: home it before the program
