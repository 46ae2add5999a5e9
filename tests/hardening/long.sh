#!/usr/bin/env bash
# long.sh BIN WORK [MINUTES]: scripted work in all workspaces, over and over; memory at each round.
# What a round makes it takes back: steps of the history and a bout that goes on are a user's own.
source "$(dirname "$0")/common.sh"
minutes=${3:-60}
project=$("$bin/kumite" demo --out "$work/demo" --seconds 120)
"$bin/kumite" label "$project" --import "$work/demo/truth.json" >/dev/null
round() {
    printf '%s\n' workspace.segment idle review.next review.reject edit.undo boundary.next \
        boundary.toggle edit.undo transport.play "wait 2000" transport.play view.side view.front \
        workspace.label idle label.next label.accept idle edit.undo "wait 300" \
        workspace.graph idle graph.view graph.view graph.nextSurprise "wait 300" \
        workspace.bout idle bout.begin idle bout.play "wait 4000" bout.play \
        workspace.keyframe idle keys.add idle keys.onTen keys.onTen keys.add idle edit.undo edit.undo \
        idle "wait 300" file.save idle
}
rounds=$((minutes * 10))  # more than a quick machine plays
: >"$work/acts"
for _ in $(seq "$rounds"); do round >>"$work/acts"; done
echo file.quit >>"$work/acts"
from=$EPOCHREALTIME
"$bin/kumite-studio" --watch --script "$work/acts" "$project" >"$work/done" 2>"$work/said" &
pid=$!
seen=0
: >"$work/memory.txt"
while kill -0 "$pid" 2>/dev/null; do
    done_=$(grep -c '^workspace.segment' "$work/done" || true)
    if [ "$done_" -gt "$seen" ]; then
        seen=$done_
        awk -v n="$seen" '/VmRSS/ {print n, int($2 / 1024)}' "/proc/$pid/status" >>"$work/memory.txt" 2>/dev/null || true
    fi
    sleep 1
    awk -v a="$from" -v b="$EPOCHREALTIME" -v m="$minutes" 'BEGIN {exit b - a < m * 60 ? 1 : 0}' && break
done
kill -0 "$pid" 2>/dev/null || wait "$pid" || fault "it ended with $?: $(tail -n 3 "$work/said")"
acts=$(wc -l <"$work/done")
[ "$seen" -gt 0 ] || fault "not one round was played"
kill "$pid" 2>/dev/null || true
wait "$pid" 2>/dev/null || true
took=$(awk -v a="$from" -v b="$EPOCHREALTIME" 'BEGIN {printf "%.0f", (b - a) / 60}')
# The first rounds fill caches; growth is judged from a quarter of the way on.
growth=$(awk '{m[NR] = $2} END {a = m[int(NR / 4) + 1]; b = m[NR]; printf "%d MB after a quarter, %d MB at the end", a, b; exit b > 1.1 * a + 30}' "$work/memory.txt") ||
    fault "memory grows: $growth"
row "scripted work in five workspaces without a pause" "$took min, $seen rounds, $acts acts" "$growth"
finish
