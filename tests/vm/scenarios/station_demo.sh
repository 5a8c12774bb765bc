# Scenario: the demo of the whole station, drawn through the kernel at the hand's own pace: a tree by its outline, a
# limb by a rule along a stroke, a plant from construction lines, a shaped branch, wind. The station is killed
# during a stroke and continues with its session; that stroke and all later ones are drawn again. Outside, the
# recordings must replay to the session's edits and to its file byte for byte, and the strokes must be where the
# hand was.
modules='dummy_hcd libcomposite usb_f_hid usb_f_fs usbhid hid-generic'
files='app/demo/station.tractus-log app/demo/station.hand.toml app/models/birch.l app/models/birch.v app/leaves/birch.leaf'
limit_s=600 # The window rebuilds three plants repeatedly, on an emulated processor.
torn=12 # The stroke that shapes the birch is interrupted.

# Prints a log in which the hand holds still for ten minutes in the middle of the n-th tool's stroke, so that an
# emulated processor has all the time that it needs to catch up with the hand.
#   hold_in_stroke N LOG
hold_in_stroke() {
    awk -v wanted="$1" '
        /^T:/ { tools++ }
        /^D:/ { device = $2 }
        /^E:/ && tools == wanted && device == 0 && !touched && $5 ~ /[13579bdf]$/ { touched = $2 }
        /^[ET]:/ && touched && $2 > touched + 0.9 { $2 = sprintf("%013.6f", $2 + 600) }
        { print }' "$2"
}

# Prints the part of a log from its n-th tool line on, as a log.
#   from_tool N LOG
from_tool() {
    awk -v wanted="$1" '
        /^T:/ { tools++ }
        /^D:/ && (begun || seen) { device = $0 }
        /^E:/ { seen = 1 }
        /^T:/ && tools == wanted { print; print device; begun = 1; next }
        !seen && !/^T:/ || begun' "$2"
}

# Starts playing a log, and watching the station.
#   begin_to_draw NUMBER LOG
begin_to_draw() {
    tractus sim gadget both "$2" >player.log 2>&1 &
    player=$!
    wait_until test -e /dev/hidraw0
    vm_check live-window birch.l station.rig.toml --session station.tractus \
        --record "got$1.tractus-log" --tools "$2" >"window$1" 2>&1 &
    station=$!
}

# Kills the station while the hand holds still in a stroke and all earlier strokes are on the disk.
kill_in_a_stroke() {
    wait_until grep -q "^kept $((torn - 1))$" window1
    sleep 1 # The pen that touched at the end of the stroke before has been lifted.
    wait_until is_drawing
    kill -9 $station || fail "the station was over: $(cat window1)" || return
    wait $station || true
    kill -TERM $player || fail "the player ended: $(cat player.log)" || return
    wait $player || cat player.log
}
is_drawing() {
    [ "$(grep -c '^stroke' window1)" -eq $((torn - 1)) ] && [ "$(grep '^the pen' window1 | tail -n 1)" = 'the pen touches' ]
}

draw_to_the_end() {
    wait $player || fail "the player ended with $?: $(cat player.log)" || return
    kill -TERM $station
    wait $station || fail "the station ended with $?: $(cat window2)"
}

guest() {
    mkdir -p /share/tractus/leaves
    cp /files/birch.leaf /share/tractus/leaves
    cp /files/station.* /files/birch.[lv] .
    sed -n 's/^C: //p' station.tractus-log >station.rig.toml
    hold_in_stroke $torn station.tractus-log >held.tractus-log
    begin_to_draw 1 held.tractus-log
    kill_in_a_stroke
    tractus session info station.tractus | grep "^steps to undo  *$((torn - 1))$" || fail 'not all of them were kept'
    from_tool $torn station.tractus-log >rest.tractus-log
    wait_until test ! -e /dev/hidraw0
    begin_to_draw 2 rest.tractus-log
    draw_to_the_end
    tractus session info station.tractus
    tractus grow station.tractus -o station.glb
    figure 'file of three plants' "$(wc -c <station.glb)" bytes
    sha256sum station.glb >station.sha256 # Only the checksum, since transferring the file would take minutes.
    hand_out station.tractus-log got?.tractus-log rest.tractus-log station.tractus station.sha256 station.hand.toml birch.l birch.v
}

# Removes the interrupted stroke, which is in the recording, but not in the session, since it was never finished.
without_torn_stroke() {
    awk '/^D:/ { device = $2 }
        { lines[NR] = $0 }
        /^E:/ && device == 0 && $5 !~ /[13579bdf]$/ { end = NR }
        END { for (i = 1; i <= end; i++) print lines[i] }' "$1"
}

judge() {
    # The emulated processor is so busy with growing that reports arrive late: at 220 mm/s, 3 mm are 14 ms.
    local limits='--rms-mm 0.5 --max-mm 3 --path-mm 1'
    vm_check strokes station.hand.toml station.tractus-log got1.tractus-log birch.l --torn --strokes $torn $limits
    vm_check strokes station.hand.toml rest.tractus-log got2.tractus-log birch.l --strokes $((14 - torn)) $limits
    without_torn_stroke got1.tractus-log >whole.tractus-log
    mkdir replayed # The exported file of a plant is named after its session.
    vm_check replay-session birch.l replayed/station.tractus whole.tractus-log got2.tractus-log
    vm_check same-drawing station.tractus replayed/station.tractus
    tractus grow replayed/station.tractus -o station.glb
    sha256sum -c station.sha256
}
