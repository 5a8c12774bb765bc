# Scenario: a standing desk with LINAK's cable, through uhid and hidraw, which is initialised, polled, and never
# moved. Its heights must be read correctly. Unplugged during a recording, it must be found again and initialised
# again.
modules='uhid hid-generic'
files='build/vm/scribble.tractus-log'

log=/files/scribble.tractus-log

guest() {
    tractus sim desk $log &
    wait_until test -e /dev/hidraw0
    record_while $! got.tractus-log # A desk that received a command to move ends its player with an error.
    vm_check same-heights $log got.tractus-log --tolerance 0.002
    vm_check gaps got.tractus-log
    wait_until test ! -e /dev/hidraw0

    record_unplugged 50 tractus sim desk $log --stay
}
