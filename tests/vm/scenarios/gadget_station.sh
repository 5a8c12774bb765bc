# Scenario: the whole station on one USB device, a pen and the project's own height sensor in a gadget, through
# hidraw and libusb, recorded live. The strokes must be where the hand was.
modules='dummy_hcd libcomposite usb_f_hid usb_f_fs usbhid hid-generic'
files='build/vm/scribble.tractus-log tests/vm/scribble.hand.toml app/models/daisy.l app/models/daisy.v'

guest() {
    sed -n 's/^C: //p' /files/scribble.tractus-log >simulated.rig.toml
    tractus sim gadget both /files/scribble.tractus-log &
    wait_until test -e /dev/hidraw0
    record_while $! got.tractus-log --rig simulated.rig.toml
    vm_check same-reports /files/scribble.tractus-log got.tractus-log --device 0
    vm_check stream got.tractus-log
    vm_check strokes /files/scribble.hand.toml /files/scribble.tractus-log got.tractus-log /files/daisy.l
}
