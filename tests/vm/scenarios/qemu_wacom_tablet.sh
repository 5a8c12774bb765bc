# Scenario: QEMU's Wacom PenPartner, moved from outside. The kernel's wacom driver switches it to its own mode and
# drops its reports before hidraw sees them, since they are shorter than its descriptor says. The libusb back end
# detaches the driver and reads them.
modules='xhci-pci usbhid wacom'
virtual_time=no
qemu='-device qemu-xhci -device usb-wacom-tablet'

outside() {
    move_pointer
}

# The report has the id 2, x and y (low byte first), buttons, pressure.
guest() {
    local recorder
    wait_until test -e /dev/hidraw0
    sleep 3 # The driver sets the mode a second after it was bound, without any sign.
    tractus devices
    tractus record -o got.tractus-log --device libusb:1-1:0 &
    recorder=$!
    wait_for_reports got.tractus-log 100
    kill -TERM $recorder
    wait $recorder
    awk '/^E:/ { reports++; own_mode += $3 == 7 && $4 == "02"; places += !seen[$5 $6]++ }
        END { print reports + 0, "reports", own_mode + 0, "in its own mode", places + 0, "places"
            exit !(reports >= 20 && own_mode == reports && places >= 20) }' got.tractus-log
}
