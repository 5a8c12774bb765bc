# For the outside() of a scenario, in bash: its output and input are QEMU's QMP.

# Says something to QEMU and waits for the answer; fails when the machine is over.
qmp() {
    local answer
    echo "$1" || return
    while read -r answer; do # Events come in between.
        case $answer in *'"return"'* | *'"error"'*) return ;; esac
    done
    return 1
}

# Moves QEMU's own tablets along the diagonal, x as large as y, back and forth, until the machine is
# over. Until somebody reads one of them, there is nothing to move, and QEMU answers with an error.
move_pointer() {
    local place=0 position
    qmp '{"execute": "qmp_capabilities"}'
    while sleep 0.01; do
        place=$(((place + 97) % 32768))
        position=$(printf '{"type": "abs", "data": {"axis": "%s", "value": %d}}, ' x $place y $place)
        qmp "{\"execute\": \"input-send-event\", \"arguments\": {\"events\": [${position%, }]}}" || return
    done 2>/dev/null
}
