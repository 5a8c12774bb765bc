# The simulated pen as a USB gadget again, at 200 Hz, now through hidapi's libusb back end, which takes
# the interface from usbhid: every report arrives, in step.
modules='dummy_hcd libcomposite usb_f_hid usbhid hid-generic'
files='build/vm/scribble.tractus-log'

# The gadget sends its first report anew each time the interface changes hands before it is read.
without_first_repeated() {
    awk '/^E:/ && !begun {
            bytes = $0
            sub(/^E: [^ ]* /, "", bytes)
            if (kept == "" || bytes == kept_bytes) { kept = $0; kept_bytes = bytes; next }
            print kept
            begun = 1
        }
        { print }' "$1"
}

guest() {
    tractus sim gadget pen /files/scribble.tractus-log --rate 200 &
    wait_until test -e /dev/hidraw0
    record_while $! got.tractus-log --device libusb:1-1:0
    without_first_repeated got.tractus-log >once.tractus-log
    vm_check same-reports /files/scribble.tractus-log once.tractus-log --device 0
    vm_check gaps once.tractus-log
}
