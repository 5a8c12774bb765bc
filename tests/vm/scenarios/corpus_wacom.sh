# The Wacom recordings with the kernel's wacom driver bound, which reads along and sets modes: what
# hidraw delivers is what was sent, and decodes to the same samples. Two are missing, since the
# driver wants those to be USB's own mice, which uhid's devices never are: DTU-2231, Intuos Pro.
modules='uhid hid-generic wacom'
corpus='recordings/wacom'
limit_s=200

guest() {
    for file in $(find /corpus/recordings -type f | grep -v -e DTU2231 -e Intuos_Pro | sort); do
        play_recording "$file" wacom
    done
}
