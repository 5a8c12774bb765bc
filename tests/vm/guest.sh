# Functions for the guest() of a scenario, in busybox's sh.

fail() {
    echo "failed: $*"
    return 1
}

# Waits until a command succeeds, and reports waits of ten seconds. A command that never succeeds is ended by the
# limit of the machine's processor time; the duration of a guest second depends on the guest's load.
#   wait_until test -e /dev/hidraw0
wait_until() {
    local tries=0
    until "$@" 2>/dev/null; do
        tries=$((tries + 1))
        [ $tries -ne 1000 ] || echo "still waits for: $*"
        sleep 0.01
    done
}

# Waits until a log that is being recorded contains more reports than now.
#   wait_for_reports LOG [COUNT]
wait_for_reports() {
    local wanted=$(($(grep -cs '^E' "$1") + ${2:-1}))
    wait_until has_reports "$1" $wanted
}
has_reports() { [ "$(grep -cs '^E' "$1")" -ge "$2" ]; }

# Prints a measured figure for the table at the end of tests/vm/run.
#   figure gap_max 5.171 ms
figure() {
    echo "figure: $1 = $2${3:+ $3}"
}

# Hands files to the scenario's judge(), which checks them outside.
#   hand_out FILE...
hand_out() {
    stty -F /dev/ttyS3 raw
    tar -cf - "$@" >/dev/ttyS3
}

# Records all devices until the process that emulates them ends.
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

# Records a device with a hidraw node that is unplugged during the recording and plugged in again: both must be
# reported, and the recording must continue.
#   record_unplugged REPORTS COMMAND...
record_unplugged() {
    local reports=$1 player recorder
    shift
    "$@" &
    player=$!
    wait_until test -e /dev/hidraw0
    tractus record -o unplugged.tractus-log 2>messages &
    recorder=$!
    wait_for_reports unplugged.tractus-log "$reports"
    kill -KILL $player
    wait_until grep -q 'has gone' messages
    "$@" &
    player=$!
    wait_until grep -q 'is back' messages
    wait_for_reports unplugged.tractus-log "$reports"
    kill -TERM $recorder
    wait $recorder
    cat messages
    kill -TERM $player
    wait $player
}

are_nodes() {
    [ "$(ls -d /dev/hidraw* 2>/dev/null | wc -l)" -eq "$1" ]
}

# Prints the pen samples of a log without their times.
samples_of() {
    tractus decode "$1" --csv 2>/dev/null | cut -d , -f 2-
}

# Prints the devices of a log that send any reports.
sending_devices_of() {
    awk 'BEGIN { device = 0 }
        /^D: *[0-9]/ { sub(/^D: */, ""); device = $1 + 0 }
        /^E:/ && !seen[device]++ { print device }' "$1" | sort -n
}

# Plays a recording's first and last reports, as HID devices through uhid or as a USB gadget, records them, and
# compares. The reports in between are skipped: the way through the kernel is the same for all, and other tests
# decode them.
#   play_recording FILE DRIVER_THAT_MUST_BIND [gadget]
play_recording() {
    local file driver=$2 way=${3:-uhid} devices player node
    rm -f got.tractus-log
    basename "$1"
    file=/begun/$(basename "$1")
    mkdir -p /begun
    awk -v count="$(grep -c '^E:' "$1")" \
        '!/^E:/ || ++place <= 400 || place > count - 800 { print }' "$1" >"$file"
    devices=$(sending_devices_of "$file")
    case $way in
    uhid) tractus sim uhid "$file" --device $devices >player.log 2>&1 & ;;
    gadget)
        devices=0 # Only the pens are counted.
        tractus sim gadget pen "$file" >player.log 2>&1 &
        ;;
    esac
    player=$!
    wait_until are_nodes "$(echo "$devices" | wc -l)" || return
    for node in /sys/class/hidraw/*; do
        [ "$(basename "$(readlink "$node/device/driver")")" = "$driver" ] \
            || fail "$driver does not drive it" || return
    done
    record_while $player got.tractus-log --device /dev/hidraw* >record.log 2>&1 || return
    vm_check same-reports "$file" got.tractus-log --device $devices || return
    samples_of "$file" >sent.csv
    samples_of got.tractus-log >got.csv
    head -n "$(wc -l <sent.csv)" got.csv | cmp sent.csv - || return # The recorded log may have more lines, since the pen leaves when it is unplugged.
    echo "  $(grep -c "^[0-9]" sent.csv) samples are the same"
    wait_until are_nodes 0
}

# Functions that print a process's processor time so far, in hundredths of a second, and its number of open files.
cpu_time() { awk '{ print $14 + $15 }' "/proc/$1/stat"; }
open_files() { ls "/proc/$1/fd" | wc -l; }

# Plays the simulated pen of a recording as a USB gadget, records it, and compares. At the beginning, the first
# report may arrive several times, about 10 ms apart.
#   play_gadget_pen LOG RATE_HZ DEVICE
play_gadget_pen() {
    echo "$2 Hz through $3"
    rm -f got.tractus-log
    tractus sim gadget pen "$1" --rate "$2" &
    wait_until test -e /dev/hidraw0 || return
    record_while $! got.tractus-log --device "$3" || return
    vm_check same-reports "$1" got.tractus-log --device 0 --first-repeated || return
    vm_check gaps got.tractus-log --pause-ms 9 || return
    test -z "$(ls /sys/kernel/config/usb_gadget)" || fail "the gadget was not removed"
}
