# Scenario: the station's live window with udevd. Tablet and height sensor are unplugged during a stroke, and
# plugged in again in another socket. Each time the window must report it, keep what was drawn as a stroke, and find
# both again; then the hand continues.
modules='dummy_hcd:num=2 libcomposite usb_f_hid usb_f_fs usbhid hid-generic'
files='build/vm/scribble.tractus-log app/models/daisy.l app/models/daisy.v'
udev=yes

log=/files/scribble.tractus-log
port=/sys/kernel/config/usb_gadget/tractus/UDC

count_lines() { grep -c "^$1" window || true; }
has_more() { [ "$(count_lines "$1")" -gt "$2" ]; }
# Functions that look at the window's last message about the pen, and its last message about a problem; it prints
# each at once.
touches() { [ "$(grep '^the pen' window | tail -n 1)" = 'the pen touches' ]; }
last_trouble_is() { grep -v -e '^the pen' -e '^stroke' -e '^kept' window | tail -n 1 | grep -q "$1"; }

unplug_in_a_stroke() {
    local strokes
    # A stroke that ended before enough of it was drawn is ignored; the next one is used.
    until wait_until has_more 'the pen touches' "$(count_lines 'the pen touches')" && sleep 0.2 && touches; do :; done
    strokes=$(count_lines stroke)
    echo >$port
    wait_until last_trouble_is 'has gone: plug it in again'
    wait_until has_more stroke $strokes # Waits for the stroke in progress.
    [ "$(count_lines stroke)" -eq $((strokes + 1)) ] || fail "there is a stroke that nobody drew" || return
    echo "$1" >$port
    wait_until last_trouble_is 'nothing is wrong'
    wait_until has_more stroke $((strokes + 1))
}

guest() {
    local window to
    sed -n 's/^C: //p' $log >simulated.rig.toml
    tractus sim gadget both $log --repeat &
    wait_until test -e /dev/hidraw0
    vm_check live-window /files/daisy.l simulated.rig.toml >window &
    window=$!
    for to in dummy_udc.1 dummy_udc.0 dummy_udc.1; do
        unplug_in_a_stroke $to || { cat window && return 1; }
    done
    kill -TERM $window
    wait $window
    figure "strokes drawn in the window" "$(count_lines stroke)"
}
