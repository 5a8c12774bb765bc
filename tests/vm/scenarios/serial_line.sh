# Scenario: a simulated board on a serial line, through a pseudo-terminal. Its heights must be read correctly, the
# recording must replay, and the board must be found again when it is unplugged during a recording.
modules=
files='build/vm/scribble.tractus-log'

log=/files/scribble.tractus-log
line=/dev/ttyHEIGHT

guest() {
    local player recorder
    mkdir -p /dev/pts
    mount -t devpts devpts /dev/pts
    tractus sim serial $log --link $line &
    player=$!
    wait_until test -e $line
    record_while $player got.tractus-log --device $line@max=4095
    vm_check same-heights $log got.tractus-log --tolerance 0.002
    vm_check gaps got.tractus-log
    test ! -e $line || fail "the link is still there"
    tractus doctor got.tractus-log | grep 'height sensor, 0 to 4095'

    tractus sim serial $log --link $line --stay &
    player=$!
    wait_until test -e $line
    tractus record -o unplugged.tractus-log --device $line@max=4095 2>messages &
    recorder=$!
    wait_for_reports unplugged.tractus-log 100
    kill -KILL $player
    wait $player || true
    wait_until grep -q 'has gone' messages
    tractus sim serial $log --link $line --stay &
    player=$!
    wait_until grep -q 'is back' messages
    wait_for_reports unplugged.tractus-log 100
    kill -TERM $recorder
    wait $recorder
    cat messages
    kill -TERM $player
    wait $player
}
