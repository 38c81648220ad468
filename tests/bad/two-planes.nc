G17 G90 G19
; expect modal-conflict 1:9
