# What the trials share. Each trial gets the folder of the programs and a folder of its own to work
# in, prints lines of one table (what, tried, result) and fails if anything was lost or fell over.
set -euo pipefail
bin=$1
work=$2
export HOME=$work/home XDG_DATA_HOME=$work/data XDG_CONFIG_HOME=$work/config LC_ALL=C.UTF-8
mkdir -p "$HOME" "$XDG_DATA_HOME" "$XDG_CONFIG_HOME"
unset XDG_RUNTIME_DIR

faults=0
row() { printf '| %s | %s | %s |\n' "$1" "$2" "$3"; }
fault() {
    printf 'fault: %s\n' "$*" >&2
    faults=$((faults + 1))
}
finish() { [ "$faults" -eq 0 ] || { printf '%s faults; look into %s\n' "$faults" "$work" >&2; exit 1; }; }

# A studio that plays a script and quits; its exit code, its words in $work/said.
studio() {
    local script=$1
    shift
    printf '%s\n' "$script" file.quit >"$work/script"
    "$bin/kumite-studio" --watch --script "$work/script" "$@" >"$work/done" 2>"$work/said"
}

# Puts peak memory and seconds of a command into cost_text: "512 MB, 3.1 s".
cost() {
    local peak=0 now pid from=$EPOCHREALTIME
    "$@" >"$work/cost.out" 2>"$work/cost.err" &
    pid=$!
    while now=$(awk '/VmHWM/ {print $2}' "/proc/$pid/status" 2>/dev/null) && [ -n "$now" ]; do
        [ "$now" -le "$peak" ] || peak=$now
        sleep 0.1
    done
    wait "$pid" || fault "$* ended with $?: $(tail -n 1 "$work/cost.err")"
    cost_text=$(awk -v kb="$peak" -v a="$from" -v b="$EPOCHREALTIME" \
        'BEGIN {printf "%d MB, %.1f s", kb / 1024, b - a}')
}
