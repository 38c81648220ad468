g0 x#<_ini[axis_0]min_limit>
m2
; expect unknown-parameter 1:5 linuxcnc | the settings file of the machine is not known to this reader (value #<_INI[AXIS_0]MIN_LIMIT>); write the value itself
