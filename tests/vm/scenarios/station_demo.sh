# Scenario: the demo of the whole station, drawn through the kernel at the hand's own pace: a tree by its outline, a
# limb by a rule along a stroke, a plant from construction lines, a shaped branch, wind. The station is killed
# during a stroke and continues with its session; that stroke and all later ones are drawn again. Outside, the
# recordings must replay to the session's edits and to its file byte for byte, and the strokes must be where the
# hand was.
modules='dummy_hcd libcomposite usb_f_hid usb_f_fs usbhid hid-generic'
files='app/demo/station.tractus-log app/demo/station.hand.toml app/models/birch.l app/models/birch.v app/leaves/birch.leaf'
limit_s=600 # The window rebuilds three plants repeatedly, on an emulated processor.
# The second stroke is interrupted; or the next one, if it ended too soon. Later, with three plants to rebuild, an
# emulated processor is more than a whole stroke behind the hand.
finished_first=1

count_lines() { grep -c "^$1" "$2" || true; }
# True if the pen draws and so many strokes have been finished.
#   is_drawing FINISHED WINDOW
is_drawing() {
    [ "$(count_lines stroke "$2")" -ge "$1" ] && [ "$(grep '^the pen' "$2" | tail -n 1)" = 'the pen touches' ]
}
is_drawing_or_over() { is_drawing "$1" "$2" || ! kill -0 "$3"; }

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

# Kills the station during a stroke and writes the stroke's number to the file "torn". First it stops the hand until
# all earlier strokes are on the disk, however long an emulated processor takes. If the window shows the pen so late
# that the stroke has already ended, the hand goes on to the next stroke.
kill_in_a_stroke() {
    while :; do
        wait_until is_drawing_or_over $finished_first window1 $player
        kill -STOP $player || fail "the player ended: $(cat player.log)" || return
        sleep 0.5 # Time for drawing the reports that the kernel already has.
        ! is_drawing $finished_first window1 || break
        echo "the stroke had ended when the hand was stopped: $(tail -n 3 window1 | tr '\n' ';')"
        kill -CONT $player
    done
    local finished=$(count_lines stroke window1) held=$(cut -d ' ' -f 1 /proc/uptime)
    wait_until grep -q "^kept $finished$" window1
    figure 'held still for' "$(awk -v held="$held" '{ print $1 - held }' /proc/uptime)" s
    kill -9 $station || fail "the station was over: $(cat window1)" || return
    wait $station || true
    kill -TERM $player
    kill -CONT $player
    wait $player || cat player.log
    echo $((finished + 1)) >torn
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
    begin_to_draw 1 station.tractus-log
    kill_in_a_stroke
    local torn=$(cat torn)
    tractus session info station.tractus | grep "^steps to undo  *$((torn - 1))$" || fail 'not all of them were kept'
    from_tool $torn station.tractus-log >rest.tractus-log
    wait_until test ! -e /dev/hidraw0
    begin_to_draw 2 rest.tractus-log
    draw_to_the_end
    tractus session info station.tractus
    tractus grow station.tractus -o station.glb
    figure 'file of three plants' "$(wc -c <station.glb)" bytes
    sha256sum station.glb >station.sha256 # Only the checksum, since transferring the file would take minutes.
    hand_out torn *.tractus-log station.tractus station.sha256 station.hand.toml birch.l birch.v
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
    local torn=$(cat torn) limits='--rms-mm 0.5 --max-mm 3 --path-mm 1'
    vm_check strokes station.hand.toml station.tractus-log got1.tractus-log birch.l --torn --strokes $torn $limits
    vm_check strokes station.hand.toml rest.tractus-log got2.tractus-log birch.l --strokes $((14 - torn)) $limits
    without_torn_stroke got1.tractus-log >whole.tractus-log
    mkdir replayed # The exported file of a plant is named after its session.
    vm_check replay-session birch.l replayed/station.tractus whole.tractus-log got2.tractus-log
    vm_check same-drawing station.tractus replayed/station.tractus
    tractus grow replayed/station.tractus -o station.glb
    sha256sum -c station.sha256
}
