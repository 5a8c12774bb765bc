# Scenario: an MCP2221A, emulated through uhid. Our driver must configure it, read its converter, and get the
# heights that it measures. Unplugged during a recording, it must be found again.
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
