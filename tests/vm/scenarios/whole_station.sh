# Scenario: the whole station without a screen: pen and height sensor of a simulated hand through the kernel,
# recorded live. The strokes must be where the hand was.
modules='uhid hid-generic'
files='build/vm/scribble.tractus-log tests/vm/scribble.hand.toml app/models/daisy.l app/models/daisy.v'

guest() {
    sed -n 's/^C: //p' /files/scribble.tractus-log >simulated.rig.toml
    tractus sim uhid /files/scribble.tractus-log &
    wait_until test -e /dev/hidraw1
    record_while $! got.tractus-log --rig simulated.rig.toml
    vm_check same-reports /files/scribble.tractus-log got.tractus-log
    vm_check strokes /files/scribble.hand.toml /files/scribble.tractus-log got.tractus-log /files/daisy.l
}
