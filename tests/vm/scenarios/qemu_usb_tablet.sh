# Scenario: QEMU's own USB tablet, an independent device, moved from outside. Hidraw must deliver the positions to
# which it was moved.
modules='xhci-pci usbhid hid-generic'
virtual_time=no
qemu='-device qemu-xhci -device usb-tablet'

outside() {
    move_pointer
}

# The report has buttons, x and y (low byte first), wheel.
guest() {
    local recorder
    wait_until test -e /dev/hidraw0
    tractus devices
    tractus record -o got.tractus-log --device /dev/hidraw0 &
    recorder=$!
    wait_for_reports got.tractus-log 100
    kill -TERM $recorder
    wait $recorder
    awk '/^E:/ { reports++; on_diagonal += $5 $6 == $7 $8; places += !seen[$5 $6]++ }
        END { print reports + 0, "reports", on_diagonal + 0, "on the diagonal", places + 0, "places"
            exit !(reports >= 20 && on_diagonal == reports && places >= 20) }' got.tractus-log
}
