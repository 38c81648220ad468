G20
; expect refused-code 1:1 thesis-a | thesis A does not accept G20 (value G20); this language is in millimetres
