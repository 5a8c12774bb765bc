# Real tablets' recordings through uhid and hid-generic: what hidraw delivers is what was sent, and
# decodes to the same samples. Of the UC-Logic tablets one recording each, and the one with a report
# that no descriptor has; of the Wacom tablets two: corpus_wacom has the others, with the driver that
# people have for them.
modules='uhid hid-generic'
corpus='recordings'
limit_s=300

guest() {
    for file in $(find /corpus -name 'n-trig*.hid' -o -name '*BambooFun*.hid' -o -name '*PenPartner*' \
        -o -name '*pen_pressure*.hidrec' -o -name '*HS610__dumps__enabled__pen_coords*' | sort); do
        play_recording "$file" hid-generic
    done
}
