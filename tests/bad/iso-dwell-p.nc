N10 G04 P2
; expect dwell 1:9 iso | P of G04 is seconds on some controls and milliseconds on others (value P2); write X and the seconds
