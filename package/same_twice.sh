#!/usr/bin/env bash
# Builds the Debian package of the last commit twice, in two folders of different names and without the compiler's cache, and
# says whether they are the same to the byte. Takes about as long as two builds.
#
#   package/same_twice.sh
#
# Exit status: 0 the same, 1 they differ or a build failed.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
export CCACHE_DISABLE=1
SOURCE_DATE_EPOCH=$(git -C "$root" log -1 --format=%ct)
export SOURCE_DATE_EPOCH
for copy in one the/other; do
    git clone -q "$root" "$folder/$copy"
    (cd "$folder/$copy" && cmake --preset release && cmake --build build -j "$(nproc)" --target twinwake shell_files &&
        cd build && cpack) >"$folder/log" 2>&1 || { tail -n 20 "$folder/log" >&2; exit 1; }
    sha256sum "$folder/$copy"/build/twinwake_*.deb | sed "s|$folder/||"
done
cmp "$folder"/one/build/twinwake_*.deb "$folder"/the/other/build/twinwake_*.deb
echo "the same twice"
