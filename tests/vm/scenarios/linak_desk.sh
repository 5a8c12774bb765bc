# A standing desk behind LINAK's cable, through uhid and hidraw: initialised, asked, and never moved.
# Its heights are those that it has. Without power and unplugged in mid-recording it is found again.
modules='uhid hid-generic'
files='build/vm/scribble.tractus-log'

log=/files/scribble.tractus-log

guest() {
    local player recorder
    tractus sim desk $log &
    wait_until test -e /dev/hidraw0
    record_while $! got.tractus-log # A desk that was told to move ends its player with an error.
    vm_check same-heights $log got.tractus-log --tolerance 0.002
    vm_check gaps got.tractus-log
    wait_until test ! -e /dev/hidraw0

    tractus sim desk $log --stay &
    player=$!
    wait_until test -e /dev/hidraw0
    tractus record -o unplugged.tractus-log 2>messages &
    recorder=$!
    wait_for_reports unplugged.tractus-log 50
    kill -KILL $player
    wait_until grep -q 'has gone' messages
    tractus sim desk $log --stay & # It has to be initialised once more.
    player=$!
    wait_until grep -q 'is back' messages
    wait_for_reports unplugged.tractus-log 50
    kill -TERM $recorder
    wait $recorder
    cat messages
    kill -TERM $player
    wait $player
}
