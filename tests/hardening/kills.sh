#!/usr/bin/env bash
# kills.sh BIN WORK [COUNT]: kill -9 at random instants of a session that corrects and saves; after
# each the project must be whole and nothing be lost but the act in progress.
source "$(dirname "$0")/common.sh"
count=${3:-200}
original=$("$bin/kumite" demo --out "$work/demo" --seconds 240)
project=$work/demo/bout.kumite

# Every toggle is of another boundary: as many removals as acts.
acts=()
for i in $(seq 45); do
    acts+=(boundary.next boundary.toggle)
    [ $((i % 9)) -ne 0 ] || acts+=("save $project")
done
printf '%s\n' "${acts[@]}" file.quit >"$work/acts"

removals() { { grep -o '"remove"' "$1" || true; } | wc -l; }
session() { exec "$bin/kumite-studio" --watch --script "$work/acts" "$project" >"$work/log" 2>"$work/said"; }

cp "$original" "$project"
from=${EPOCHREALTIME/./}
(session) || fault "the session ends with $?"
length=$((${EPOCHREALTIME/./} - from))
[ "$(removals "$project")" -eq 45 ] || fault "the undisturbed session saved $(removals "$project") of 45"

recovered=0 inTime=0
RANDOM=1
for i in $(seq "$count"); do
    rm -rf "$XDG_DATA_HOME" "$work"/demo/.bout.kumite.lock "$work/log"
    cp "$original" "$project"
    session &
    pid=$!
    # Uniform over the session, its start included.
    sleep "$(awk -v us="$length" -v r="$RANDOM" 'BEGIN {printf "%.3f", us / 1e6 * r / 32768}')"
    kill -9 "$pid" 2>/dev/null || true
    wait "$pid" 2>/dev/null || true
    done_=$({ grep -c "^boundary.toggle" "$work/log" 2>/dev/null || true; })
    "$bin/kumite" segment "$project" >/dev/null 2>"$work/said" ||
        fault "kill $i: the project cannot be read: $(cat "$work/said")"
    kept=$(removals "$project")
    if compgen -G "$XDG_DATA_HOME/kumite/kumite-studio/recovery/*.edit" >/dev/null; then
        recovered=$((recovered + 1))
        rm -f "$work/demo/recovered.kumite"
        studio "recover
save $work/demo/recovered.kumite" || fault "kill $i: not recovered: $(cat "$work/said")"
        kept=$(removals "$work/demo/recovered.kumite")
    fi
    [ "$done_" -eq 45 ] || inTime=$((inTime + 1))
    if [ "$kept" -lt "$done_" ] || [ "$kept" -gt $((done_ + 1)) ]; then
        fault "kill $i: $done_ acts were done, $kept are kept"
    fi
done
row "kill -9 of the studio at random instants of a session of 45 corrections and 5 saves" \
    "$count kills, $inTime before the session's end; $recovered left a copy that was recovered" \
    "$([ "$faults" -eq 0 ] && echo 'every project readable, every finished act kept' || echo "$faults faults")"
finish
