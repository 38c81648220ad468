G43 H1
; expect refused-code 1:1 grblhal | grblHAL does not accept G43 (value G43); use G43.1 with the length in Z; grblHAL answers error:20
