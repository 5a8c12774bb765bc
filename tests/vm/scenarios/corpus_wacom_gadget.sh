# The Wacom recordings for which uhid is not enough, as USB gadgets, with the kernel's wacom driver
# bound: what hidraw delivers is what was sent, and decodes to the same samples.
#
# The driver asks of the DTU-2231 and the Intuos Pro what kind of USB interface they are, and answers the
# Intuos3's reports by asking the tablet something, for which uhid would make it wait.
modules='dummy_hcd libcomposite usb_f_hid usbhid hid-generic wacom'
corpus='recordings/wacom'
limit_s=300

guest() {
    for file in $(find /corpus -name '*DTU2231*' -o -name '*Intuos3*' -o -name '*Intuos_Pro*' | sort); do
        play_recording "$file" wacom gadget
    done
}
