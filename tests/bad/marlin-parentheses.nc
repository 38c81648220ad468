G0 X1 (up)
; expect comment 1:7 marlin | parentheses are no comment here (value (); begin the comment with ;
