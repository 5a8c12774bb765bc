# Scenario: the Wacom recordings with the kernel's wacom driver bound, which reads along and sets modes. Hidraw must
# deliver what was sent, and it must decode to the same samples.
#
# Three recordings are in corpus_wacom_gadget instead. For the DTU-2231 and the Intuos Pro, the driver asks for the
# kind of USB interface, which uhid devices do not have. It answers the Intuos3's reports with requests to the
# tablet, which uhid delays for five seconds each, since the emulated tablet is busy sending.
modules='uhid hid-generic wacom'
corpus='recordings/wacom'
limit_s=300

guest() {
    for file in $(find /corpus -type f | grep -v -e DTU2231 -e Intuos3 -e Intuos_Pro | sort); do
        play_recording "$file" wacom
    done
}
