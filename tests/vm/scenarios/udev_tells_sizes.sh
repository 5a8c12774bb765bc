# Scenario: a tablet's size, as known to the kernel and udev, must be in the recording of its reports.
modules='uhid hid-generic evdev'
udev=yes

# Descriptor of report 1 of a digitizer's pen: tip switch, in range, X of 0 to 20,000 and Y of 0 to 12,500. The unit
# is the centimetre with exponent -3 (HID 1.11, 6.2.2.7), so the size is 200 x 125 mm.
pen='05 0d 09 02 a1 01 85 01 09 20 a1 00'
pen="$pen 09 42 09 32 15 00 25 01 75 01 95 02 81 02 95 06 81 03"
pen="$pen 05 01 65 11 55 0d 75 10 95 01 35 00"
pen="$pen 09 30 26 20 4e 46 20 4e 81 02"
pen="$pen 09 31 26 d4 30 46 d4 30 81 02 c0 c0"

guest() {
    local player length
    length=$(echo "$pen" | wc -w)
    {
        echo "R: $length $pen"
        echo 'N: A tablet'
        echo 'I: 3 1209 0002'
        for i in 0 1 2 3 4 5 6 7 8 9; do
            echo "E: 00000$i.000000 6 01 02 10 27 0$i 00"
        done
    } >tablet.log
    tractus sim uhid tablet.log >played 2>&1 &
    player=$!
    wait_until test -e /dev/hidraw0 || { cat played; return 1; }
    udevadm settle
    tractus record -o recorded.log --device /dev/hidraw0 --seconds 1 >said 2>&1 || true
    kill "$player"
    wait "$player" || true
    grep -q '^A: 200 125$' recorded.log || { cat said recorded.log; fail 'no size in the recording'; }
}
