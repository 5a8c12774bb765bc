# Scenario: the udev rules must permit pens of any maker, recognised by their report descriptors, and nothing else.
modules='uhid hid-generic'
udev=yes

# Writes the log of a device that sends nothing for two seconds.
#   write_device LOG BUS VENDOR PRODUCT LENGTH DESCRIPTOR
write_device() {
    {
        echo "R: $5 $6"
        echo 'N: A device'
        echo "I: $2 $3 $4"
        echo 'E: 000000.000000 2 01 00'
        echo 'E: 000002.000000 2 01 00'
    } >"$1"
}

# Prints udev's tags of a log's device while it is present.
tags_of() {
    local player
    tractus sim uhid "$1" >played 2>&1 &
    player=$!
    wait_until test -e /dev/hidraw0 || { cat played; return 1; }
    udevadm settle
    udevadm info --query=property --name=/dev/hidraw0 >properties
    sed -n 's/^TAGS=//p' properties
    kill "$player"
    wait "$player" || true
    wait_until test ! -e /dev/hidraw0
}

# Descriptor of report 1 with a tip switch and padding.
pen='05 0d 09 02 a1 01 85 01 09 20 a1 00 09 42 15 00 25 01 75 01 95 01 81 02 95 07 81 03 c0 c0'
mouse='05 01 09 02 a1 01 85 01 05 09 19 01 29 01 15 00 25 01 75 01 95 01 81 02 95 07 81 03 c0'

guest() {
    write_device i2c_pen.log 18 2d1f 0001 30 "$pen"
    write_device usb_pen.log 3 2179 0053 30 "$pen"
    write_device mouse.log 3 045e 0001 29 "$mouse"
    for log in i2c_pen usb_pen; do
        tags_of $log.log >tags
        grep -q ':uaccess:' tags || fail "$log: no rule permits it" || return
    done
    tags_of mouse.log >tags
    ! grep -q ':uaccess:' tags || fail 'a rule permits a mouse' || return
}
