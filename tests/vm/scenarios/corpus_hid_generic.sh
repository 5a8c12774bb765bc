# Scenario: recordings of real tablets through uhid and hid-generic. Hidraw must deliver what was sent, and it must
# decode to the same samples. Of the UC-Logic tablets there is one recording each, and the one with a report that no
# descriptor has; of the Wacom tablets two, since corpus_wacom has the others, with the driver that users have for
# them.
modules='uhid hid-generic'
corpus='recordings'
limit_s=300

guest() {
    for file in $(find /corpus -name 'n-trig*.hid' -o -name '*BambooFun*.hid' -o -name '*PenPartner*' \
        -o -name '*pen_pressure*.hidrec' -o -name '*HS610__dumps__enabled__pen_coords*' | sort); do
        play_recording "$file" hid-generic
    done
}
