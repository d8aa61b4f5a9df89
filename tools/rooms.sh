#!/usr/bin/env bash
# Who includes whom among the rooms (folders) of this checkout, and whether that is what docs/ARCHITECTURE.md says.
#
#   tools/rooms.sh [--in CHECKOUT]           checks all of it
#   tools/rooms.sh [--in CHECKOUT] ROOM      lists the includes among the rooms within ROOM, such as sph_solver
#   tools/rooms.sh [--in CHECKOUT] --count   for each room: files, lines, includes of other rooms, rooms in it in a circle
#
# The check: a room uses base and what the table "The rooms" gives it (whole rooms, or a folder of one, such as
# `compare/report`), all of which stand above it in the table; what the table gives is used; every folder that CMake makes
# a room (tw_room), and the program's, is in the table; no room includes tests. Within each room, its folders and the files
# that lie beside them (a file with its header) are rooms again: none is in a circle with another. Where the page has a
# table "folder of `ROOM/`" it names every folder of that room, each above all that it includes.
#
# Exit status: 0 nothing found, 1 something found (one line each), 2 wrong usage.
set -euo pipefail
export LC_ALL=C
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
count=0 only=""
while [ $# -gt 0 ]; do
    case $1 in
        -h | --help) sed -n '2,/^set /{/^set /d;s/^# \{0,1\}//;p}' "$0"; exit 0 ;;
        --in) root=${2:?--in needs a folder}; shift ;;
        --count) count=1 ;;
        -*) echo "rooms.sh: unknown option $1" >&2; exit 2 ;;
        *) only=${1%/} ;;
    esac
    shift
done
cd "$root" || exit 2
page=docs/ARCHITECTURE.md
[ -f "$page" ] || { echo "rooms.sh: no $page in $root" >&2; exit 2; }
[ -z "$only" ] || [ -d "$only" ] || { echo "rooms.sh: no folder $only in $root" >&2; exit 2; }

# What the tables of the page say, line by line: "room NAME", "use NAME TARGET", "all NAME"; "inner ROOM ROW NAME".
tables() {
    awk -F'|' '
    !/^\|/ { table = ""; next }
    table == "" {
        if ($2 ~ /^ *folder *$/ && $4 ~ /may use/) table = "rooms"
        else if (match($2, /folder of `[a-z_]+\/`/)) { table = "inner"; owner = substr($2, RSTART + 11, RLENGTH - 13) }
        else table = "other"
        next
    }
    /^\| *-/ { next }
    { names = $2; row++ }
    table == "rooms" && match(names, /`[a-z_]+\/`/) {
        name = substr(names, RSTART + 1, RLENGTH - 3)
        print "room", name
        uses = $4
        sub(/;.*/, "", uses)
        if (uses ~ /all of the above/) print "all", name
        while (match(uses, /`[a-z_\/]+`/)) {
            print "use", name, substr(uses, RSTART + 1, RLENGTH - 2)
            uses = substr(uses, RSTART + RLENGTH)
        }
    }
    table == "inner" {
        while (match(names, /`[a-z_]+\/`/)) {
            print "inner", owner, row, substr(names, RSTART + 1, RLENGTH - 3)
            names = substr(names, RSTART + RLENGTH)
        }
    }' "$page"
}
mapfile -t rooms < <({ tables | awk '$1 == "room" { print $2 }'
                       grep -lE '^tw_room\(|^add_executable\(twinwake' -- */CMakeLists.txt 2>/dev/null | sed 's|/.*||'; } |
                     awk '!seen[$0]++' | while read -r room; do [ -d "$room" ] && echo "$room"; done)
sources() { find "$@" -type f \( -name '*.h' -o -name '*.cpp' \) -print | sort; }
includes() {   # FILE TARGET of each include of a path with a folder
    sources "$@" | tr '\n' '\0' | xargs -0 -r grep -HoE '^[[:space:]]*#[[:space:]]*include "[a-z_]+/[^"]*"' -- |
        awk '{ split($0, part, "\""); file = $0; sub(/:.*/, "", file); print file, part[2] }'
}

{
    tables
    for room in "${rooms[@]}"; do echo "there $room"; done
    for room in "${rooms[@]}"; do
        find "$room" -mindepth 1 -maxdepth 1 -type d | sort | while read -r folder; do
            [ -z "$(sources "$folder")" ] || echo "folder $folder"
        done
        sources "$room" | tr '\n' '\0' | xargs -0 -r wc -l | awk -v room="$room" '
            $2 != "total" { files++; lines += $1 } END { print "size", room, files + 0, lines + 0 }'
    done
    [ ${#rooms[@]} -eq 0 ] || includes "${rooms[@]}" | sed 's/^/include /'
} | awk -v only="$only" -v count="$count" '
function top(path) { sub(/\/.*/, "", path); return path }
function inner(path) {  # the room within a room that a file stands in
    sub(/^[^\/]*\//, "", path)
    if (index(path, "/")) return top(path)
    sub(/\.[a-z]+$/, "", path)
    return path
}
function tell(text) { print text; found = 1 }
function short(text) { return length(text) > 120 ? substr(text, 1, 120) "..." : text }
$1 == "room" { place[$2] = ++rooms; name[rooms] = $2 }
$1 == "use" { uses[$2, $3] = 1; given[++gifts] = $2 SUBSEP $3 }
$1 == "all" { all[$2] = 1 }
$1 == "inner" { row[$2, $4] = $3 + 0; has_table[$2] = 1; named[++names_inside] = $2 "/" $4 }
$1 == "there" { there[$2] = 1; order[++rooms_there] = $2 }
$1 == "folder" { folder[$2] = 1; folders[++folder_count] = $2 }
$1 == "size" { files[$2] = $3; lines[$2] = $4 }
$1 == "include" {
    from = top($2); to = top($3)
    if (to == "tests") tests[++tests_used] = $2
    if (from == to) {
        a = inner($2); b = inner($3)
        if (a == b) next
        if (!((from, a) in known)) { known[from, a] = 1; inside[from, ++inside_count[from]] = a }
        if (!((from, b) in known)) { known[from, b] = 1; inside[from, ++inside_count[from]] = b }
        example[from, a, b] = example[from, a, b] (example[from, a, b] ? ", " : "") substr($2, length(from) + 2)
        times[from, a, b]++
    } else if (to in there) {
        others[from]++
        if (!((from, to) in times_of_rooms)) pairs[++pair_count] = from SUBSEP to
        times_of_rooms[from, to]++
        used[++uses_count] = $2 SUBSEP $3
    }
}
END {
    # the rooms within a room that are in a circle: from each of them one can come back to it
    for (r = 1; r <= rooms_there; r++) {
        owner = order[r]; n = inside_count[owner]
        for (i = 1; i <= n; i++)
            for (j = 1; j <= n; j++)
                reaches[owner, i, j] = (owner, inside[owner, i], inside[owner, j]) in times
        for (k = 1; k <= n; k++)
            for (i = 1; i <= n; i++)
                if (reaches[owner, i, k])
                    for (j = 1; j <= n; j++)
                        if (reaches[owner, k, j]) reaches[owner, i, j] = 1
        for (i = 1; i <= n; i++) circle_size[owner] += reaches[owner, i, i]
    }
    if (only != "") {
        for (i = 1; i <= inside_count[only]; i++)
            for (j = 1; j <= inside_count[only]; j++) {
                a = inside[only, i]; b = inside[only, j]
                if ((only, a, b) in times) print a " -> " b "  (" times[only, a, b] ")" | "sort"
            }
        close("sort")
    }
    if (count) {
        printf "%-12s %6s %7s %9s %10s\n", "room", "files", "lines", "includes", "in circles"
        for (r = 1; r <= rooms_there; r++) {
            owner = order[r]
            printf "%-12s %6d %7d %9d %10d\n", owner, files[owner], lines[owner], others[owner], circle_size[owner]
        }
        exit 0
    }
    for (r = 1; r <= rooms_there; r++) {
        owner = order[r]; n = inside_count[owner]
        if (only != "" && only != owner) continue
        for (i = 1; i <= n; i++)
            for (j = 1; j <= n; j++) {
                a = inside[owner, i]; b = inside[owner, j]
                if (reaches[owner, j, i] && (owner, a, b) in times)
                    tell("circle in " owner ": " a " -> " b " by " short(example[owner, a, b]))
                if ((owner, a, b) in times && (owner, a) in row && (owner, b) in row && row[owner, b] > row[owner, a])
                    tell(owner "/" a " stands above " owner "/" b " in the page and includes it: " \
                         short(example[owner, a, b]))
            }
    }
    if (only != "") {
        if (!found) print "no room is in a circle with another"
        exit found
    }
    for (r = 1; r <= rooms_there; r++)
        if (!(order[r] in place)) tell("the room " order[r] " is not in the table of rooms")
    for (r = 1; r <= rooms; r++)
        if (!(name[r] in there)) tell("the table of rooms has " name[r] ", which is not there")
    for (k = 1; k <= gifts; k++) {
        split(given[k], of, SUBSEP)
        if (!(top(of[2]) in place) || place[top(of[2])] >= place[of[1]])
            tell("the table gives " of[1] " the use of " of[2] ", which does not stand above it")
    }
    for (k = 1; k <= uses_count; k++) {
        split(used[k], of, SUBSEP)
        from = top(of[1]); to = top(of[2]); path = of[2]
        allowed = to == "base" || ((from in all) && place[to] < place[from])
        while (1) {
            if ((from, path) in uses) { allowed = 1; by_table[from, path] = 1 }
            if (!sub(/\/[^\/]*$/, "", path)) break
        }
        if (!allowed) tell(of[1] " includes " of[2] ", and the table gives " from " no use of it")
    }
    for (k = 1; k <= gifts; k++) {
        split(given[k], of, SUBSEP)
        if (of[2] == "base") { if (times_of_rooms[of[1], "base"]) continue }
        else if ((of[1], of[2]) in by_table) continue
        tell("the table gives " of[1] " the use of " of[2] ", and nothing there includes it")
    }
    for (k = 1; k <= tests_used; k++) tell(tests[k] " includes tests")
    for (k = 1; k <= folder_count; k++)
        if (top(folders[k]) in has_table && !((top(folders[k]), inner(folders[k] "/x")) in row))
            tell("the folder " folders[k] " is not in the table of its room")
    for (k = 1; k <= names_inside; k++)
        if (!(named[k] in folder)) tell("the table of " top(named[k]) " has " named[k] ", which is not there")
    if (!found) print rooms " rooms: no circle, and no use beyond the table"
    exit found
}'
