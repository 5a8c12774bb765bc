# A simulated pen as a USB gadget on the kernel's dummy_hcd, at 1000 Hz through usbhid, hid-generic
# and hidraw: every report arrives, in step.
modules='dummy_hcd libcomposite usb_f_hid usbhid hid-generic'
files='build/vm/scribble.tractus-log'

guest() {
    tractus sim gadget pen /files/scribble.tractus-log --rate 1000 &
    wait_until test -e /dev/hidraw0
    record_while $! got.tractus-log
    vm_check same-reports /files/scribble.tractus-log got.tractus-log --device 0
    vm_check gaps got.tractus-log
}
