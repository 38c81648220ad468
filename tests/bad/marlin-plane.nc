G18
; expect refused-code 1:1 marlin | Marlin does not accept G18 (value G18); planes are an option of the build: leave it out, arcs are in XY
