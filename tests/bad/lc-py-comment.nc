(py,import os)
m2
; expect not-supported 1:1 linuxcnc | this comment would run Python on the machine (value PY); take it out
