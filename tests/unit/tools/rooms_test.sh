#!/usr/bin/env bash
# tools/rooms.sh (its path is the argument) passes a sound checkout and names every fault put into it.
set -uo pipefail
check=$1
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

# A checkout of three rooms: low, middle with the folders of two floors, and the program above them.
begin() {
    rm -rf "$folder/tree"
    mkdir -p "$folder/tree/docs" "$folder/tree"/{base,low,middle/first,middle/second,app} && cd "$folder/tree" || exit 1
    cat >docs/ARCHITECTURE.md <<'END'
| folder | what lives there | may use |
|---|---|---|
| `base/` | errors | nothing of ours |
| `low/` | files | `base` |
| `middle/` | two floors | `low`; no `app` |
| `app/` | the program | all of the above |

| folder of `middle/` | holds |
|---|---|
| `first/` | what stands on the ground |
| `second/` | what stands on it |
END
    for room in base low middle; do echo "tw_room($room SOURCES x.cpp)" >"$room/CMakeLists.txt"; done
    echo 'add_executable(twinwake main.cpp)' >app/CMakeLists.txt
    file base/errors.h
    file low/file.h base/errors.h
    file middle/first/floor.h low/file.h
    file middle/second/floor.h middle/first/floor.h
    file middle/roof.h middle/second/floor.h
    file middle/roof.cpp middle/roof.h middle/second/floor.h
    file app/main.cpp middle/roof.h low/file.h
}
file() {   # PATH INCLUDED...: a file that includes these
    local path=$1
    shift
    printf '#include "%s"\n' "$@" >"$path"
    [ $# -gt 0 ] || : >"$path"
}
allow() { sed -i "s@^| \`$1/\` .*@| \`$1/\` | rooms | $2 |@" docs/ARCHITECTURE.md; }

wrong=0
expect() {   # OUTPUT: what the check has to say of the checkout as it stands; without it, nothing
    local said status
    said=$("$check" --in "$folder/tree")
    status=$?
    [ -n "$1" ] || said=$([ "$said" = '4 rooms: no circle, and no use beyond the table' ] || echo "$said")
    if [ "$said" != "$1" ] || [ "$status" != $([ -z "$1" ]; echo $?) ]; then
        printf 'expected: %s\nfound (%d): %s\n' "$1" "$status" "$said"
        wrong=1
    fi
}
begin; expect ''
begin; file low/file.h base/errors.h middle/roof.h
expect 'low/file.h includes middle/roof.h, and the table gives low no use of it'
begin; allow middle '`low`, `app`'
expect 'the table gives middle the use of app, which does not stand above it
the table gives middle the use of app, and nothing there includes it'
begin; file app/main.cpp middle/roof.h; allow app '`low`, `middle`'
expect 'the table gives app the use of low, and nothing there includes it'
begin; allow app '`low`, `middle/first`'   # a folder of a room does not stand for the room
expect 'app/main.cpp includes middle/roof.h, and the table gives app no use of it
the table gives app the use of middle/first, and nothing there includes it'
begin; file app/main.cpp middle/first/floor.h; allow app '`middle/first`'; expect ''
begin; file middle/first/floor.h low/file.h middle/roof.h   # of three, through a file and two folders
expect 'circle in middle: first -> roof by first/floor.h
circle in middle: roof -> second by roof.cpp, roof.h
circle in middle: second -> first by second/floor.h'
begin; file low/file.h low/other.h base/errors.h; file low/other.h; file low/other.cpp low/other.h low/file.h
expect 'circle in low: file -> other by file.h
circle in low: other -> file by other.cpp'
begin; sed -i '/`first/d' docs/ARCHITECTURE.md; expect 'the folder middle/first is not in the table of its room'
begin; sed -i '/`first/d' docs/ARCHITECTURE.md; echo '| `first/` | the ground |' >>docs/ARCHITECTURE.md
expect 'middle/second stands above middle/first in the page and includes it: second/floor.h'
begin; echo '| `third/` | gone |' >>docs/ARCHITECTURE.md
expect 'the table of middle has middle/third, which is not there'
begin; mkdir new; echo 'tw_room(new SOURCES x.cpp)' >new/CMakeLists.txt; file new/x.h low/file.h
expect 'the room new is not in the table of rooms
new/x.h includes low/file.h, and the table gives new no use of it'
begin; mkdir tests; file tests/scenes.h; file low/file.h tests/scenes.h base/errors.h; expect 'low/file.h includes tests'
exit $wrong
