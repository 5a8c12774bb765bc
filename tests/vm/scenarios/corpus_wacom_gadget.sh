# Scenario: the Wacom recordings for which uhid is not sufficient, as USB gadgets, with the kernel's wacom driver
# bound. Hidraw must deliver what was sent, and it must decode to the same samples.
#
# For the DTU-2231 and the Intuos Pro, the driver asks for the kind of USB interface; it answers the Intuos3's
# reports with requests to the tablet, which uhid would delay.
modules='dummy_hcd libcomposite usb_f_hid usbhid hid-generic wacom'
corpus='recordings/wacom'
limit_s=300

guest() {
    for file in $(find /corpus -name '*DTU2231*' -o -name '*Intuos3*' -o -name '*Intuos_Pro*' | sort); do
        play_recording "$file" wacom gadget
    done
}
