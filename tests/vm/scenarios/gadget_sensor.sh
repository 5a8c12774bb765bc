# Scenario: the station's own height sensor as a USB gadget, with 1000 readings a second through libusb. Every frame
# must arrive, complete and in order.
modules='dummy_hcd libcomposite usb_f_fs'
files='build/vm/scribble.tractus-log'

guest() {
    tractus sim gadget sensor /files/scribble.tractus-log &
    wait_until test -e /sys/bus/usb/devices/1-1/1-1:1.0/interface
    record_while $! got.tractus-log
    vm_check stream got.tractus-log
    vm_check gaps got.tractus-log
}
