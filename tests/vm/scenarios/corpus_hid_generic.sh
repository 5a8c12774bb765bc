# Real tablets' recordings through uhid and hid-generic: what hidraw delivers is what was sent, and
# decodes to the same samples.
modules='uhid hid-generic'
corpus='recordings'
limit_s=200

guest() {
    for file in $(find /corpus/recordings -name '*.hid' -o -name '*.hidrec' | sort); do
        play_recording "$file" hid-generic
    done
}
