# A standing desk behind LINAK's cable, emulated through uhid: our driver initialises it, asks for its
# height through feature reports, and gets what it was moved to. Unplugged in mid-recording it is
# found again, and initialised again.
modules='uhid hid-generic'
files='build/vm/scribble.tractus-log'

log=/files/scribble.tractus-log

guest() {
    local player recorder
    tractus sim desk $log &
    wait_until test -e /dev/hidraw0
    tractus devices
    record_while $! got.tractus-log
    vm_check same-heights $log got.tractus-log --tolerance 0.002
    vm_check gaps got.tractus-log
    wait_until test ! -e /dev/hidraw0

    tractus sim desk $log --stay &
    player=$!
    wait_until test -e /dev/hidraw0
    tractus record -o unplugged.tractus-log 2>messages &
    recorder=$!
    wait_for_reports unplugged.tractus-log 20
    kill -KILL $player
    wait_until grep -q 'has gone' messages
    tractus sim desk $log --stay &
    player=$!
    wait_until grep -q 'is back' messages
    wait_for_reports unplugged.tractus-log 20
    kill -TERM $recorder
    wait $recorder
    cat messages
    kill -TERM $player
    wait $player
}
