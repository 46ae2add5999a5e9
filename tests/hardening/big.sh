#!/usr/bin/env bash
# big.sh BIN WORK: an hour at 120 Hz, and a project of a thousand takes. The aim is 2 GB at most.
source "$(dirname "$0")/common.sh"
k=$bin/kumite
measured() {
    local what=$1 tried=$2
    shift 2
    cost "$@"
    row "$what" "$tried" "$cost_text"
}
hour=$work/hour
measured "1 h at 120 Hz, two fighters" "made (demo)" "$k" demo --out "$hour" --seconds 3600 --fps 120
project=$(ls "$hour"/*.kumite)
measured "" "read, contact force, boundaries (segment)" "$k" segment "$project"
measured "" "all true labels taken over" "$k" label "$project" --import "$hour/truth.json"
measured "" "labels written (labels)" "$k" labels "$project" --out "$hour/all.csv"
measured "" "the graph learned and written (model --graph)" "$k" model "$project" --graph "$hour/graph.json"
measured "" "60 s of a made bout (bout)" "$k" bout "$project" --out "$hour/bout" --seconds 60
printf "%s\n" idle workspace.segment boundary.next boundary.toggle transport.play "wait 3000" transport.play \
    workspace.label idle label.next "wait 500" workspace.graph idle file.save idle file.quit >"$work/acts"
measured "" "studio: opened, corrected, played, labels, graph, saved" \
    "$bin/kumite-studio" --watch --script "$work/acts" "$project"
rm -rf "$hour"

many=$work/many
"$k" demo --out "$many" --seconds 10 >/dev/null
# The same two recordings under a thousand names: every take is read and measured for itself.
awk -v n=1000 '{all = all $0 "\n"} END {
    begin = index(all, "\"takes\": [") + length("\"takes\": [")
    end = match(substr(all, begin), /\n  \]/)
    take = substr(all, begin, end - 1)
    printf "%s", substr(all, 1, begin - 1)
    for (i = 1; i <= n; i++) {
        copy = take
        sub(/"name": "[^"]*"/, "\"name\": \"round " i "\"", copy)
        printf "%s%s", copy, i < n ? "," : ""
    }
    printf "%s", substr(all, begin + end - 1)
}' "$many/demo.kumite" >"$many/thousand.kumite"
measured "1000 takes of two fighters" "read and segmented (segment)" "$k" segment "$many/thousand.kumite"
printf "%s\n" idle workspace.segment idle take.next take.next boundary.next boundary.toggle edit.undo edit.redo \
    workspace.label idle file.save idle file.quit >"$work/acts"
measured "" "studio: opened, takes changed, corrected, labels, saved" \
    "$bin/kumite-studio" --watch --script "$work/acts" "$many/thousand.kumite"
"$k" segment "$many/thousand.kumite" --json >"$work/seg.json" 2>/dev/null || fault "the thousand takes cannot be read"
[ "$({ grep -o '"remove"' "$many/thousand.kumite" || true; } | wc -l)" -eq 1 ] || fault "the correction is gone"
finish
