# An MCP3208, modelled at its pins, on the lines of a CP2112, which the kernel's own driver makes a
# gpiochip: our driver reads each of its channels right through libgpiod. Then the lines fail, and
# then the bridge is unplugged, each in mid-recording: both are told, and nothing hangs.
modules='uhid hid-cp2112'
files='build/vm/scribble.tractus-log'

address=gpio:cp2112_gpio:0,1,2,3:mcp3208

# Channel 7 has 0.8 of full scale, and so on down; the pen's recording is none of our business.
read_channels() {
    local channel
    for channel in 0 1 2 3 4 5 6 7; do
        tractus record --device $address:$channel --seconds 0.3 -o channel$channel.tractus-log
    done
    for channel in 1 2 3 4 5 6 7; do
        vm_check height channel$channel.tractus-log --fraction 0.$((channel + 1))
    done
    vm_check gaps channel7.tractus-log
}

guest() {
    tractus sim cp2112 /files/scribble.tractus-log --repeat &
    wait_until test -e /dev/gpiochip0
    read_channels
    kill -KILL $!
}
