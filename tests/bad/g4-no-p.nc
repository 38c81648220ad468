G4
; expect missing-word 1:1
