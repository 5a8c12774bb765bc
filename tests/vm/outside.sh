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

# Moves QEMU's own tablets along the diagonal, x as large as y, back and forth, until the verdict is
# there: QEMU may hang if it is told something while it ends. Until somebody reads one of the
# tablets, there is nothing to move, and QEMU answers with an error.
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
