# Scenario: an MCP3421 on the I2C bus of a CP2112, which the kernel's own drivers expose as industrial I/O. Its
# heights must be read correctly through sysfs. Unplugged during a recording, it must be found again.
modules='uhid hid-cp2112 mcp3422'
files='build/vm/scribble.tractus-log'

log=/files/scribble.tractus-log
sensor=iio:device0:voltage0@max=2047
value=/sys/bus/iio/devices/iio:device0/in_voltage0_raw

is_bus() { grep -l CP2112 /sys/bus/i2c/devices/i2c-*/name; }

# Tells the kernel which chip is on the bus.
attach_chip() {
    wait_until is_bus
    echo mcp3421 0x68 >"$(dirname "$(is_bus)")/new_device"
    wait_until test -e $value
}

guest() {
    local player recorder
    tractus sim iio $log &
    player=$!
    attach_chip
    tractus devices | grep iio:device0:voltage0
    record_while $player got.tractus-log --device $sensor
    vm_check same-heights $log got.tractus-log --tolerance 0.002
    wait_until test ! -e $value

    tractus sim iio $log --stay &
    player=$!
    attach_chip
    tractus record -o unplugged.tractus-log --device $sensor 2>messages &
    recorder=$!
    wait_for_reports unplugged.tractus-log 50
    kill -KILL $player
    wait_until grep -q 'has gone' messages
    tractus sim iio $log --stay &
    player=$!
    attach_chip
    wait_until grep -q 'is back' messages
    wait_for_reports unplugged.tractus-log 50
    kill -TERM $recorder
    wait $recorder
    cat messages
    kill -TERM $player
    wait $player
}
