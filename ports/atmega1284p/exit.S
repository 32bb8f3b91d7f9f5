; ports/atmega1284p/exit.S: avr-libc's start-up goes on here with what main returned in r24.
    .global exit
exit:
    rcall board_exit
1:  rjmp 1b
