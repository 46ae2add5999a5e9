#!/usr/bin/env bash
# files.sh BIN WORK: recordings and folders that change under the programs' hands.
source "$(dirname "$0")/common.sh"
original=$("$bin/kumite" demo --out "$work/demo" --seconds 120)
removals() { { grep -o '"remove"' "$1" || true; } | wc -l; }

# with_studio ACT…: a studio has the project open while ACT happens; it corrects, saves and quits.
with_studio() {
    cp "$original" "$work/demo/bout.kumite"
    studio "boundary.next
boundary.toggle
wait 1500
boundary.next
boundary.toggle
transport.play
wait 300
transport.play
segment.compare
save $work/demo/bout.kumite" "$work/demo/bout.kumite" &
    local shell=$!
    until grep -q boundary.toggle "$work/done" 2>/dev/null || ! kill -0 "$shell" 2>/dev/null; do
        sleep 0.05
    done
    sleep 0.3
    "$@"
    wait "$shell" || fault "the studio ended with $? after $*: $(tail -n 1 "$work/said")"
    rm -f "$work/done"
    [ "$(removals "$work/demo/bout.kumite")" -eq 2 ] || fault "after $* a correction is gone"
}
recording=$work/demo/player1.bvh
cp "$recording" "$work/whole.bvh"
tried=0
for act in "rm $recording" "truncate -s 50000 $recording" "truncate -s 0 $recording" \
    "cp $work/demo/player2.bvh $recording"; do
    with_studio $act
    # Opened again: the corrections are there, and what is wrong is said.
    studio "idle
save $work/again.kumite" "$work/demo/bout.kumite" || fault "cannot be opened after $act"
    [ "$(removals "$work/again.kumite")" -eq 2 ] || fault "opening after $act loses corrections"
    "$bin/kumite" segment "$work/demo/bout.kumite" >/dev/null 2>"$work/said" || true
    grep -q "player1.bvh" "$work/said" || fault "nothing is said after $act"
    cp "$work/whole.bvh" "$recording"
    tried=$((tried + 1))
done
row "recording removed, cut, emptied, replaced by another while the studio has it open" \
    "$tried faults, each: correct, play, compare, save, quit, open again" \
    "no crash, all corrections kept, the recording named"

RANDOM=2
cut=0
cp "$work/whole.bvh" "$work/cut.bvh"
"$bin/kumite" info "$work/cut.bvh" >"$work/whole.txt" 2>&1
for i in $(seq 60); do
    cp "$work/whole.bvh" "$work/cut.bvh"
    "$bin/kumite" info "$work/cut.bvh" >"$work/cut.txt" 2>&1 &
    reader=$!
    sleep "$(awk -v r="$RANDOM" 'BEGIN {printf "%.3f", 0.06 * r / 32768}')"
    truncate -s $((RANDOM * 20)) "$work/cut.bvh"
    code=0
    wait "$reader" || code=$?
    [ "$code" -lt 126 ] || fault "reading a file that is cut meanwhile ended with $code"
    cmp -s "$work/cut.txt" "$work/whole.txt" || cut=$((cut + 1))
done
row "recording cut while it is being read" "60 times; $cut came in time" \
    "what is there is read and the rest is said, or a sentence with line and column; no crash"

# Two studios on one project: the second is told that it is taken, works on a copy and saves that.
cp "$original" "$work/demo/bout.kumite"
printf '%s\n' boundary.next boundary.toggle "wait 2500" "save $work/demo/bout.kumite" file.quit \
    >"$work/first"
"$bin/kumite-studio" --watch --script "$work/first" "$work/demo/bout.kumite" >/dev/null 2>"$work/said1" &
first=$!
sleep 1.2
studio "boundary.next
boundary.next
boundary.toggle
boundary.next
boundary.toggle
save $work/demo/second.kumite" "$work/demo/bout.kumite" || fault "the second studio ended with $?"
wait "$first" || fault "the first studio ended with $?: $(cat "$work/said1")"
all=("$work"/demo/*.kumite "$work"/demo/.kumite-versions/bout.kumite/*.kumite)
states=$(for file in "${all[@]}"; do removals "$file"; done | sort -n | tr '\n' ' ')
grep -q 1 <<<"$states" || fault "the first studio's edit is nowhere: $states"
grep -q 2 <<<"$states" || fault "the second studio's edits are nowhere: $states"
grep -q "is open in another studio" "$work/said" || fault "the second was not told of the first"
row "two studios on one project, both edit and save" "one trial" \
    "the second is told and works on a copy; the edits of both are kept"

if [ "$(id -u)" -eq 0 ] && mkdir -p "$work/small" && mount -t tmpfs -o size=256k none "$work/small"; then
    trap 'umount "$work/small"' EXIT
    cp "$original" "$work/demo/bout.kumite"
    sed "s|\"player|\"$work/demo/player|g" "$original" >"$work/small/bout.kumite"
    before=$(sha256sum <"$work/small/bout.kumite")
    head -c 300000 /dev/zero >"$work/small/full" 2>/dev/null || true
    printf '%s\n' boundary.next boundary.toggle "save $work/small/bout.kumite" >"$work/script"
    "$bin/kumite-studio" --watch --script "$work/script" --run file.quit "$work/small/bout.kumite" \
        >"$work/done" 2>"$work/said" || true
    [ "$(sha256sum <"$work/small/bout.kumite")" = "$before" ] || fault "a full disk took the project"
    mount -o remount,ro "$work/small"
    "$bin/kumite-studio" --watch --script "$work/script" --run file.quit "$work/small/bout.kumite" \
        >"$work/done" 2>"$work/said" || true
    [ "$(sha256sum <"$work/small/bout.kumite")" = "$before" ] || fault "a read-only disk took the project"
    row "disk full, disk read-only while saving" "one trial each, in the studio" \
        "the old file stays whole"
else
    row "disk full, disk read-only while saving" "not tried: needs root" ""
fi
finish
