# The Wacom recordings with the kernel's wacom driver bound, which reads along and sets modes: what
# hidraw delivers is what was sent, and decodes to the same samples.
#
# Three are in corpus_wacom_gadget. The driver asks of the DTU-2231 and the Intuos Pro what kind of USB
# interface they are, which uhid's devices are not; and it answers the Intuos3's reports by asking the
# tablet something, for which uhid makes it wait five seconds each time, since the tablet is still
# busy sending.
modules='uhid hid-generic wacom'
corpus='recordings/wacom'
limit_s=300

guest() {
    for file in $(find /corpus -type f | grep -v -e DTU2231 -e Intuos3 -e Intuos_Pro | sort); do
        play_recording "$file" wacom
    done
}
