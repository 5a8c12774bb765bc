# Scenario: the project's own height sensor is unplugged and plugged in again ten times while a recording runs and
# the pen draws. The sensor must be found each time, no frame may be corrupt, strokes drawn until then must be kept,
# and the recorder must neither leak nor spin. There is no udevd here, so no event announces the sensor's return.
modules='dummy_hcd libcomposite usb_f_fs uhid hid-generic'
files='build/vm/scribble.tractus-log app/models/daisy.l app/models/daisy.v'

port=/sys/kernel/config/usb_gadget/tractus/UDC

count_reports() { grep -c '^E: .* 26 54 52 48' got.tractus-log || true; }
has_more_than() { [ "$(count_reports)" -gt "$1" ]; }

# Unplugs for a second, in which the recorder may use a quarter of the (slow) processor.
unplug_and_plug_in() {
    local before=$(cpu_time "$1") used had
    echo >$port
    sleep 1
    used=$(($(cpu_time "$1") - before))
    [ $used -le 25 ] || fail "$used hundredths of a second went by in waiting" || return
    [ $used -le $worst ] || worst=$used
    had=$(count_reports)
    echo dummy_udc.0 >$port
    wait_until has_more_than $((had + 100))
}

guest() {
    local files recorder worst=0
    tractus sim gadget sensor /files/scribble.tractus-log --repeat &
    wait_until test -e /sys/bus/usb/devices/1-1/1-1:1.0/interface
    tractus sim uhid /files/scribble.tractus-log --device 0 --rate 18 --stay & # Plays one slowly drawn stroke.
    wait_until test -e /dev/hidraw0
    sed -n 's/^C: //p' /files/scribble.tractus-log >simulated.rig.toml
    tractus record --rig simulated.rig.toml -o got.tractus-log &
    recorder=$!
    wait_until has_more_than 50
    files=$(open_files $recorder)
    for i in 1 2 3 4 5 6 7 8 9 10; do
        unplug_and_plug_in $recorder
    done
    [ "$(open_files $recorder)" -eq "$files" ] || fail "open files: $files, then $(open_files $recorder)"
    kill -TERM $recorder
    wait $recorder
    figure "processor while unplugged, at most" $worst %
    vm_check stream got.tractus-log --restarts 10
    vm_check interrupted-strokes got.tractus-log /files/daisy.l --least 10
}
