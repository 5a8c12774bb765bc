# An MCP2221A, emulated through uhid: our driver sets it up, reads its converter, and gets the
# heights that it measures. Unplugged in mid-recording it is found again.
modules='uhid hid-generic'
files='build/vm/scribble.tractus-log'

log=/files/scribble.tractus-log

guest() {
    tractus sim mcp2221a $log &
    wait_until test -e /dev/hidraw0
    record_while $! got.tractus-log
    vm_check same-heights $log got.tractus-log --tolerance 0.002
    vm_check gaps got.tractus-log
    wait_until test ! -e /dev/hidraw0

    record_unplugged 100 tractus sim mcp2221a $log --stay
}
