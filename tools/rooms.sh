#!/usr/bin/env bash
# Lists which rooms (folders) of sph_solver include which, and the rooms that are in a circle with one another. A file that
# lies beside the folders is a room of its own, together with its header. docs/ARCHITECTURE.md says what each room is for.
#
#   tools/rooms.sh [FOLDER]     the rooms of another folder than sph_solver
#
# Exit status: 0 no room is in a circle with another, 1 some are.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
case ${1:-} in -h | --help) sed -n '2,/^set /{/^set /d;s/^# \{0,1\}//;p}' "$0"; exit 0 ;; esac
folder=${1:-sph_solver}

grep -r --include='*.h' --include='*.cpp' -E "^#include \"$folder/" "$folder" | LC_ALL=C sort | awk -v folder="$folder/" '
function room(path) {  # of a file in the folder
    path = substr(path, length(folder) + 1)
    if (index(path, "/")) return substr(path, 1, index(path, "/") - 1)
    sub(/\.[a-z]+$/, "", path)
    return path
}
{
    split($0, part, "\"")
    file = $0
    sub(/:.*/, "", file)
    from = room(file)
    to = room(part[2])
    if (from == to) next
    known[from] = known[to] = 1
    includes[from, to]++
    example[from, to] = example[from, to] (example[from, to] ? ", " : "") substr(file, length(folder) + 1)
    reaches[from, to] = 1
}
END {
    for (via in known)
        for (a in known)
            if ((a, via) in reaches)
                for (b in known)
                    if ((via, b) in reaches) reaches[a, b] = 1
    for (pair in includes) {
        split(pair, of, SUBSEP)
        print of[1] " -> " of[2] "  (" includes[pair] ")" | "LC_ALL=C sort"
    }
    close("LC_ALL=C sort")
    for (a in known) {
        if (!((a, a) in reaches)) continue
        circle = 1
        for (b in known)
            if (((a, b) in includes) && ((b, a) in reaches))
                print "circle: " a " -> " b " by " example[a, b] | "LC_ALL=C sort >&2"
    }
    close("LC_ALL=C sort >&2")
    if (!circle) print "no room is in a circle with another"
    exit circle
}'
