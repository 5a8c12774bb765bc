# An MCP2221A that others use, too. What another program asks is answered to every reader of the
# chip, and our driver drops it. When the kernel's own driver comes, it takes the chip away from
# all: the recording says so, the doctor says what to do about the driver, and when that is done,
# the recording goes on.
modules='uhid hid-generic hid-mcp2221'
files='build/vm/scribble.tractus-log'

log=/files/scribble.tractus-log

# Asks for the levels of the pins, command 51, again and again.
ask_for_pins() {
    { printf '\000\121' && head -c 63 /dev/zero; } >question
    for i in $(seq 100); do
        dd if=question of=/dev/hidraw0 bs=65 count=1 2>/dev/null
        sleep 0.02
    done
}

# How many of the chip's answers, 64 bytes each, are to command $1.
count_answers() { od -An -v -tx1 -w64 answers | grep -c "^ $1" || true; }
has_answers() { [ "$(count_answers "$1")" -ge "$2" ]; }

share_with_a_program() {
    local witness
    cat /dev/hidraw0 >answers &
    witness=$!
    wait_until test -s answers
    ask_for_pins
    wait_until has_answers 51 100 # The other program's.
    wait_until has_answers 10 500 # Our own.
    kill $witness
    figure "answers to another program" "$(count_answers 51)"
}

# The driver looks at the chip for 24 s, since this kernel lets no answers through meanwhile.
share_with_the_kernel() {
    insmod /modules.d/hid-mcp2221.ko
    wait_until grep -q 'has gone' messages
    tractus doctor --seconds 0 >findings 2>&1 || true # It finds the driver.
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
