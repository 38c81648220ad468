G20
; expect refused-code 1:1 thesis-a | thesis A does not accept G20 (value G20, limit G0, G2, G3, G90, G91, M2, M30); this language is in millimetres
