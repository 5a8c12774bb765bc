# Scenario: a draw-wire encoder on the lines of a CP2112, which the kernel's own driver exposes as a gpiochip that
# reports edges. Our driver must count all of them, up and down. Then the bridge is unplugged during a recording,
# which must be reported.
modules='uhid hid-cp2112'
files='build/vm/scribble.tractus-log'

log=/files/scribble.tractus-log
address=gpio:cp2112_gpio:0,1:quadrature

# A chip whose lines are in use when it disappears keeps its number.
is_chip() { ls /dev/gpiochip*; }
is_no_chip() { ! is_chip; }

guest() {
    local player recorder
    tractus sim encoder $log --counts 40 &
    wait_until is_chip >/dev/null
    record_while $! got.tractus-log --device $address 2>messages
    cat messages
    vm_check same-counts $log got.tractus-log --counts 40
    wait_until is_no_chip >/dev/null

    tractus sim encoder $log --stay &
    player=$!
    wait_until is_chip >/dev/null
    tractus record --device $address -o unplugged.tractus-log 2>messages &
    recorder=$!
    wait_for_reports unplugged.tractus-log 100
    kill -KILL $player
    wait_until grep -q 'has gone' messages
    cat messages
    kill -TERM $recorder
    wait $recorder
}
