# Scenario: the kernel keeps 64 reports for a reader and drops later ones. A station that is busy for two seconds
# must nevertheless lose no report of a 1000 Hz pen.
modules='uhid hid-generic'
files='build/vm/scribble.tractus-log'

guest() {
    tractus sim uhid /files/scribble.tractus-log --device 0 --rate 1000 &
    wait_until test -e /dev/hidraw0
    vm_check read-late /dev/hidraw0 /files/scribble.tractus-log --seconds 2
}
