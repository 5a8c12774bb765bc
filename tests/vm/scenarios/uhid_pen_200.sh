# Scenario: a simulated pen at 200 Hz through uhid, hid-generic and hidraw. Every report must arrive, in order.
modules='uhid hid-generic'
files='build/vm/scribble.tractus-log'

guest() {
    tractus sim uhid /files/scribble.tractus-log --device 0 --rate 200 &
    wait_until test -e /dev/hidraw0
    tractus devices
    record_while $! got.tractus-log
    vm_check same-reports /files/scribble.tractus-log got.tractus-log --device 0
    vm_check gaps got.tractus-log
}
