G91.1
; expect refused-code 1:1 marlin | Marlin does not accept G91.1 (value G91.1); Marlin would read G91 or G90: leave it out
