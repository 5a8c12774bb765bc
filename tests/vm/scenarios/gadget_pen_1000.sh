# Scenario: a simulated pen at 1000 Hz as a USB gadget on the kernel's dummy_hcd, through the kernel's drivers and
# hidraw, and through hidapi's libusb back end. Every report must arrive, in order, and the gadget must leave
# nothing behind.
modules='dummy_hcd libcomposite usb_f_hid usbhid hid-generic'
files='build/vm/scribble.tractus-log'

guest() {
    play_gadget_pen /files/scribble.tractus-log 1000 /dev/hidraw0
    play_gadget_pen /files/scribble.tractus-log 1000 libusb:1-1:0
}
