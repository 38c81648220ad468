G90.1
; expect refused-code 1:1 grblhal | grblHAL does not accept G90.1 (value G90.1); grblHAL takes arc centres from the start point only (G91.1); grblHAL answers error:20
