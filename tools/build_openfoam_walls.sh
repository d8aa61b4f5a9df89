#!/usr/bin/env bash
# Builds twinwake's three libraries for the OpenFOAM whose environment is loaded (openfoam.com or openfoam.org, from a
# package with its sources or built by hand): walls that let water go where air can come (foam_cases/ventilated_wall),
# zones that absorb waves with an inlet at which waves enter (foam_cases/forcing_zones), and what holds a free hull until
# its release (foam_cases/held_body).
#
#   source /opt/openfoam12/etc/bashrc               # or openfoam2506, a module, ...
#   tools/build_openfoam_walls.sh FOLDER            -> FOLDER/walls/openfoam.org-12/libventilatedWall.so
#                                                      FOLDER/walls/openfoam.org-12/libforcingZones.so
#                                                      FOLDER/walls/openfoam.org-12/libheldBody.so
#
# FOLDER is .openfoam beside twinwake's sources, ~/.local/share/twinwake/openfoam or /usr/local/lib/twinwake/openfoam;
# there twinwake finds it. `twinwake setup-openfoam` calls this script with the right one.
# A minute. `twinwake doctor` says whether walls let water go, zones absorb waves and a hull is held: it runs a flow with
# an exact answer between such walls, which are held, and through such a zone, and leaves a library out that does not load
# or spoils the answer. Without the first, walls hold water under tension; without the second, streams that need zones are
# refused; without the third, a free hull is free at once.
# For Debian's and Ubuntu's own package tools/build_openfoam_solvers.sh builds it with the solver. Needs g++ and make.
set -euo pipefail

source_folder=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)/foam_cases
die() { echo "build_openfoam_walls: $*" >&2; exit 1; }
[ $# = 1 ] && [[ $1 != -* ]] || { sed -n '2,/^set /{/^set /d;s/^# \{0,1\}//;p}' "$0"; exit 2; }
[ -n "${WM_PROJECT_DIR:-}" ] && [ -n "${FOAM_SRC:-}" ] ||
    die "no OpenFOAM environment is loaded (WM_PROJECT_DIR, FOAM_SRC); source the etc/bashrc of the release first"
command -v wmake >/dev/null || die "wmake is not on the PATH; the loaded OpenFOAM ($WM_PROJECT_DIR) has no developer's part"
[ -d "$FOAM_SRC/finiteVolume/lnInclude" ] ||
    die "$FOAM_SRC/finiteVolume/lnInclude is missing: the loaded OpenFOAM has no sources; install its developer's package"

version=${WM_PROJECT_VERSION#v}
case $version in
    '' | *[!0-9]*) die "release '$WM_PROJECT_VERSION' has no number; expected v2506, 12, ..." ;;
esac
if [ "$version" -gt 1000 ]; then release=openfoam.com-v$version; else release=openfoam.org-$version; fi

mkdir -p "$1/walls/$release"
target=$(cd "$1/walls/$release" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
build() {  # $1 from the folder $2, linked to $3 too
    local folder=$work/$1
    mkdir -p "$folder/Make"
    cp "$source_folder/$2"/*.[CH] "$source_folder"/../waves/wave_{sum,components}.h "$folder"
    # wmake knows the release's compiler, its flags and, for openfoam.com, its number (OPENFOAM).
    (cd "$folder" && printf '%s\n' *.C "LIB = $folder/$1") >"$folder/Make/files"
    # shellcheck disable=SC2016,SC1003   # make's variables, and its lines that go on
    printf '%s\n' 'EXE_INC = -I$(LIB_SRC)/finiteVolume/lnInclude -I$(LIB_SRC)/meshTools/lnInclude \' \
        '-I$(LIB_SRC)/sixDoFRigidBodyMotion/lnInclude -I$(LIB_SRC)/rigidBodyMotion/sixDoFRigidBodyMotion/lnInclude \' \
        '-I$(LIB_SRC)/dynamicMesh/lnInclude -I$(LIB_SRC)/motionSolvers/lnInclude' \
        "LIB_LIBS = -lfiniteVolume -lmeshTools ${3:-}" >"$folder/Make/options"
    (cd "$folder" && wmake libso .) >"$folder/log" 2>&1 || { cat "$folder/log" >&2; die "$1 did not build, see above"; }
    mv "$folder/$1.so" "$target/.new" && mv "$target/.new" "$target/$1.so"
    echo "$target/$1.so built for $release"
}
build libventilatedWall ventilated_wall
build libforcingZones forcing_zones
build libheldBody held_body -lsixDoFRigidBodyMotion
