# A standing desk behind LINAK's cable, through uhid and hidraw: initialised, asked, and never moved.
# Its heights are those that it has. Unplugged in mid-recording it is found again, and initialised anew.
modules='uhid hid-generic'
files='build/vm/scribble.tractus-log'

log=/files/scribble.tractus-log

guest() {
    tractus sim desk $log &
    wait_until test -e /dev/hidraw0
    record_while $! got.tractus-log # A desk that was told to move ends its player with an error.
    vm_check same-heights $log got.tractus-log --tolerance 0.002
    vm_check gaps got.tractus-log
    wait_until test ! -e /dev/hidraw0

    record_unplugged 50 tractus sim desk $log --stay
}
