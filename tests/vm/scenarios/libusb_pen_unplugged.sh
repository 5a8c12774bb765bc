# Scenario: a pen read through hidapi's libusb back end is unplugged during a recording, plugged in again in another
# socket on another bus, and then in the first one. It must be found each time.
modules='dummy_hcd:num=2 libcomposite usb_f_hid usbhid hid-generic'
files='build/vm/scribble.tractus-log'

port=/sys/kernel/config/usb_gadget/tractus/UDC

count_reports() { grep -c '^E:' got.tractus-log || true; }
has_more_than() { [ "$(count_reports)" -gt "$1" ]; }
count_told() { grep -c "$1" messages || true; }
was_told() { [ "$(count_told "$1")" -eq "$2" ]; }

plug_in_again_at() {
    local had times=$(($(count_told 'is back') + 1))
    echo >$port
    wait_until was_told 'has gone' $times || return
    had=$(count_reports)
    echo "$1" >$port
    wait_until was_told 'is back' $times || return
    wait_until has_more_than $((had + 100))
}

guest() {
    local recorder
    tractus sim gadget pen /files/scribble.tractus-log --rate 200 --repeat &
    wait_until test -e /dev/hidraw0
    tractus record --device libusb:1-1:0 -o got.tractus-log 2>messages &
    recorder=$!
    wait_until has_more_than 100
    plug_in_again_at dummy_udc.1
    plug_in_again_at dummy_udc.0
    kill -TERM $recorder
    wait $recorder
    cat messages
}
