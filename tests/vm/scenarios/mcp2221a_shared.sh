# Scenario: an MCP2221A that is used by others, too. Replies to another program reach every reader of the chip, and
# our driver must drop them. When the kernel's own driver is loaded, it takes the chip away from all: the recording
# must report this, the doctor must say what to do about the driver, and afterwards the recording must continue.
modules='uhid hid-generic hid-mcp2221'
files='build/vm/scribble.tractus-log'

log=/files/scribble.tractus-log

# Requests the levels of the pins, command 0x51, repeatedly.
ask_for_pins() {
    { printf '\000\121' && head -c 63 /dev/zero; } >question
    for i in $(seq 100); do
        dd if=question of=/dev/hidraw0 bs=65 count=1 2>/dev/null
        sleep 0.02
    done
}

# Prints how many of the chip's replies, 64 bytes each, are to command $1.
count_answers() { od -An -v -tx1 -w64 answers | grep -c "^ $1" || true; }
has_answers() { [ "$(count_answers "$1")" -ge "$2" ]; }

share_with_a_program() {
    local witness
    cat /dev/hidraw0 >answers &
    witness=$!
    wait_until test -s answers
    ask_for_pins
    wait_until has_answers 51 100 # Replies to the other program.
    wait_until has_answers 10 500 # Replies to our own program.
    kill $witness
    figure "answers to another program" "$(count_answers 51)"
}

# The driver probes the chip for 24 s, because this kernel does not pass on replies meanwhile.
share_with_the_kernel() {
    insmod /modules.d/hid-mcp2221.ko
    wait_until grep -q 'has gone' messages
    tractus doctor --seconds 0 >findings 2>&1 || true # The doctor must find the driver.
    cat findings
    grep -q 'blacklist hid_mcp2221' findings
    rmmod hid_mcp2221
    wait_until grep -q 'is back' messages
}

guest() {
    local recorder player
    rmmod hid_mcp2221
    tractus sim mcp2221a $log --stay &
    player=$!
    wait_until test -e /dev/hidraw0
    tractus record -o got.tractus-log 2>messages &
    recorder=$!
    share_with_a_program
    share_with_the_kernel
    wait_for_reports got.tractus-log 100
    kill -TERM $recorder
    wait $recorder
    cat messages
    ! grep -q '^E: [0-9.]* 64 51' got.tractus-log || fail "answers to another program were taken for ours"
    kill -TERM $player
    wait $player
}
