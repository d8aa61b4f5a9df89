#!/usr/bin/env bash
# Puts the distribution's ParaView into a folder, for the test of tools/paraview_both.py. It cannot be installed beside
# what twinwake is built with: Debian's python3-paraview conflicts with python3-vtk9, which libvtk9-dev needs. Its
# packages are therefore fetched and unpacked (73 MB to fetch, 530 MB unpacked); the libraries that it uses are those
# that libvtk9-dev brings.
#
#   tools/unpack_paraview.sh FOLDER      then: FOLDER/bin/pvpython SCRIPT, on a display (Xvfb makes one in memory)
#
# Exit status: 0 it is there; 1 it could not be fetched, or libraries are missing (named); 2 wrong usage.
set -euo pipefail
[ $# = 1 ] && [[ $1 != -* ]] || { sed -n '2,9p' "${BASH_SOURCE[0]}" | cut -c3- >&2; exit 2; }
if [ -x "$1/bin/pvpython" ]; then exit 0; fi
mkdir -p "$1"
folder=$(cd "$1" && pwd)
new=$(mktemp -d "$folder/new.XXXXXX")
trap 'rm -rf "$new"' EXIT
(cd "$new" && apt-get -q download paraview python3-paraview) ||
    { echo "unpack_paraview: apt-get fetched no ParaView" >&2; exit 1; }
for package in "$new"/*.deb; do dpkg-deb -x "$package" "$new/root"; done
library=$(dirname "$(find "$new/root/usr/lib" -name 'libvtkCommonCore-pv*.so' | head -n 1)")
missing=$(LD_LIBRARY_PATH=$library ldd "$new/root/usr/bin/pvpython" "$library"/libvtkRemotingViews-pv*.so |
    sed -n 's/^\s*\(.*\) => not found/\1/p' | sort -u)
[ -z "$missing" ] || { echo "unpack_paraview: libraries are missing: $missing" >&2; exit 1; }
rm -rf "$folder/usr"
mv "$new/root/usr" "$folder/usr"
mkdir -p "$folder/bin"
cat >"$new/pvpython" <<'END'
#!/bin/sh
top=$(cd "$(dirname "$0")/.." && pwd)
libraries=$(dirname "$(ls "$top"/usr/lib/*/libvtkCommonCore-pv*.so | head -n 1)")
export LD_LIBRARY_PATH="$libraries${LD_LIBRARY_PATH:+:$LD_LIBRARY_PATH}"
export PYTHONPATH="$top/usr/lib/python3/dist-packages${PYTHONPATH:+:$PYTHONPATH}"
exec "$top/usr/bin/pvpython" "$@"
END
chmod +x "$new/pvpython"
mv "$new/pvpython" "$folder/bin/pvpython"
