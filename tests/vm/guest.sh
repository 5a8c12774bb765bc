# For the guest() of a scenario, in busybox's sh.

fail() {
    echo "failed: $*"
    return 1
}

# Waits until a command succeeds, for at most ten seconds of the guest's clock.
#   wait_until test -e /dev/hidraw0
wait_until() {
    local tries=0
    until "$@" 2>/dev/null; do
        tries=$((tries + 1))
        [ $tries -lt 1000 ] || fail "waited ten seconds for: $*" || return
        sleep 0.01
    done
}

# A measured figure, for the table that tests/vm/run ends with.
#   figure gap_max 5.171 ms
figure() {
    echo "figure: $1 = $2${3:+ $3}"
}

# Records what there is until the process that plays the devices ends.
#   record_while PLAYER_PID LOG [OPTION...]
record_while() {
    local player=$1 recorder
    shift
    tractus record -o "$@" &
    recorder=$!
    wait "$player" || fail "the player ended with $?" || return
    kill -TERM "$recorder"
    wait "$recorder"
}
