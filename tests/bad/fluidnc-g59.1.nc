G59.1
; expect refused-code 1:1 fluidnc | FluidNC does not accept G59.1 (value G59.1); FluidNC has G54 to G59; FluidNC answers error:20
