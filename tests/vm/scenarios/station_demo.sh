# The demo of the whole station, drawn through the kernel at the hand's own pace: a tree by its
# outline, a limb by a rule along a stroke, a plant from construction lines, a shaped branch, wind.
# The station is killed in the middle of a stroke, and goes on with its session; the stroke is drawn
# again, and all that comes behind it. Outside, the recordings replay to the session's edits and to
# its file byte for byte, and the strokes lie where the hand was.
modules='dummy_hcd libcomposite usb_f_hid usb_f_fs usbhid hid-generic'
files='app/demo/station.tractus-log app/demo/station.hand.toml app/models/birch.l app/models/birch.v app/leaves/birch.leaf'
limit_s=600 # The window grows three plants again and again, on an emulated processor.
torn=12 # The stroke that is torn: the one that shapes the birch.

count_lines() { grep -c "^$1" "$2" || true; }
has_touched_or_ended() { [ "$(count_lines 'the pen touches' "$2")" -ge "$1" ] || ! kill -0 "$3"; }

# What of a log comes from its n-th tool line on, as a log.
#   from_tool N LOG
from_tool() {
    awk -v wanted="$1" '
        /^T:/ { tools++ }
        /^D:/ && (begun || seen) { device = $0 }
        /^E:/ { seen = 1 }
        /^T:/ && tools == wanted { print; print device; begun = 1; next }
        !seen && !/^T:/ || begun' "$2"
}

# Plays a log, and runs the station until the player ends; or until a stroke is torn.
#   draw NUMBER LOG [STROKE_TO_KILL_IN]
draw() {
    local log=$2 kill_in=$3 player station
    tractus sim gadget both "$log" >player.log 2>&1 &
    player=$!
    wait_until test -e /dev/hidraw0
    vm_check live-window birch.l station.rig.toml --session station.tractus \
        --record "got$1.tractus-log" --tools "$log" >"window$1" 2>&1 &
    station=$!
    if [ -n "$kill_in" ]; then
        wait_until has_touched_or_ended "$kill_in" "window$1" $station
        sleep 0.6
        kill -9 $station || { cat "window$1" && return 1; }
        wait $station || true
        kill -TERM $player
        wait $player || cat player.log
        [ "$(tail -n 1 "window$1")" = 'the pen touches' ] || fail 'it was killed between two strokes'
    else
        wait $player || fail "the player ended with $?: $(cat player.log)" || return
        kill -TERM $station
        wait $station || fail "the station ended with $?: $(cat "window$1")"
    fi
}

guest() {
    mkdir -p /share/tractus/leaves
    cp /files/birch.leaf /share/tractus/leaves
    cp /files/station.* /files/birch.[lv] .
    sed -n 's/^C: //p' station.tractus-log >station.rig.toml
    from_tool $torn station.tractus-log >rest.tractus-log
    draw 1 station.tractus-log $torn
    [ "$(count_lines stroke window1)" -eq $((torn - 1)) ] || fail 'not all strokes before it were finished'
    tractus session info station.tractus | grep "^steps to undo  *$((torn - 1))$" || fail 'not all of them were kept'
    wait_until test ! -e /dev/hidraw0
    draw 2 rest.tractus-log
    tractus session info station.tractus
    tractus grow station.tractus -o station.glb
    figure 'file of three plants' "$(wc -c <station.glb)" bytes
    sha256sum station.glb >station.sha256 # The file itself would take minutes to come out.
    hand_out *.tractus-log station.tractus station.sha256 station.hand.toml birch.l birch.v
}

# The torn stroke is in the recording, but not in the session: it was never finished.
without_torn_stroke() {
    awk '/^D:/ { device = $2 }
        { lines[NR] = $0 }
        /^E:/ && device == 0 && $5 !~ /[13579bdf]$/ { end = NR }
        END { for (i = 1; i <= end; i++) print lines[i] }' "$1"
}

judge() {
    # The processor is so busy with growing that reports come late: that is what the largest error is.
    local limits='--rms-mm 0.5 --max-mm 2'
    vm_check strokes station.hand.toml station.tractus-log got1.tractus-log birch.l --torn --strokes $torn $limits
    vm_check strokes station.hand.toml rest.tractus-log got2.tractus-log birch.l --strokes $((14 - torn)) $limits
    without_torn_stroke got1.tractus-log >whole.tractus-log
    mkdir replayed # A file of a plant has the name of its session.
    vm_check replay-session birch.l replayed/station.tractus whole.tractus-log got2.tractus-log
    vm_check same-drawing station.tractus replayed/station.tractus
    tractus grow replayed/station.tractus -o station.glb
    sha256sum -c station.sha256
}
