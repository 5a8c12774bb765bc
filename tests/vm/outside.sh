# Functions for the outside() of a scenario, in bash; its input and output are QEMU's QMP connection.

# Sends a command to QEMU and waits for the answer; fails when the machine has ended.
qmp() {
    local answer
    echo "$1" || return
    while read -r answer; do # Events may arrive before the answer.
        case $answer in *'"return"'* | *'"error"'*) return ;; esac
    done
    return 1
}

# Moves QEMU's own tablets along the diagonal, with equal x and y, back and forth, until the verdict is there: QEMU
# may hang if it receives commands while it ends. As long as nobody reads the tablets, QEMU answers with an error.
move_pointer() {
    local place=0 position
    qmp '{"execute": "qmp_capabilities"}'
    until [ -s "$folder/verdict" ]; do
        sleep 0.01
        place=$(((place + 97) % 32768))
        position=$(printf '{"type": "abs", "data": {"axis": "%s", "value": %d}}, ' x $place y $place)
        qmp "{\"execute\": \"input-send-event\", \"arguments\": {\"events\": [${position%, }]}}" || return
    done 2>/dev/null
}
