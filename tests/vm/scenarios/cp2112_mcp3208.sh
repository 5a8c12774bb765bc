# Scenario: an MCP3208, modelled at its pins, on the lines of a CP2112, which the kernel's own driver exposes as a
# gpiochip. Our driver must read all channels correctly through libgpiod, and the heights while they move. Then the
# lines fail and, in another recording, the bridge is unplugged: both must be reported.
modules='uhid hid-cp2112'
files='build/vm/scribble.tractus-log'

log=/files/scribble.tractus-log
address=gpio:cp2112_gpio:0,1,2,3:mcp3208

# Reads the height while it moves, and then the other channels, which have constant levels.
read_channels() {
    local channel
    tractus record --device $address:0 --seconds 2 -o got.tractus-log
    vm_check same-heights $log got.tractus-log --tolerance 0.002
    vm_check gaps got.tractus-log
    for channel in 1 2 3 4 5 6 7; do
        tractus record --device $address:$channel --seconds 0.1 -o channel$channel.tractus-log
        vm_check height channel$channel.tractus-log --fraction 0.$((channel + 1))
    done
}

# Waits until the recorder reports that the converter has gone, and then stops it.
lose_converter() {
    wait_until grep -q 'has gone' messages
    cat messages
    kill -TERM "$1"
    wait "$1"
}

unplug() {
    kill -$1 $player
    wait $player || true
    wait_until test ! -e /dev/gpiochip0
}

guest() {
    local player recorder
    tractus sim cp2112 $log --stay &
    player=$!
    wait_until test -e /dev/gpiochip0
    read_channels
    unplug TERM

    tractus sim cp2112 $log --stay --fail-after 0.5 &
    player=$!
    wait_until test -e /dev/gpiochip0
    tractus record --device $address:0 -o failed.tractus-log 2>messages &
    lose_converter $!
    unplug TERM

    tractus sim cp2112 $log --stay &
    player=$!
    wait_until test -e /dev/gpiochip0
    tractus record --device $address:0 -o unplugged.tractus-log 2>messages &
    recorder=$!
    wait_for_reports unplugged.tractus-log 100
    unplug KILL
    lose_converter $recorder
}
