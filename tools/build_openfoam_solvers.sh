#!/usr/bin/env bash
# Builds a sound interFoam from the source of the distribution's own OpenFOAM package, linked to the packaged libraries.
#
# Debian's OpenFOAM 1912 solvers are miscompiled: an in-place product of temporary fields lets the result share memory
# with an operand that is declared __restrict__, so velocities are wrong on every mesh that is not aligned with the axes.
# Here the same source is compiled with that keyword switched off. `twinwake doctor` proves the result by a flow whose
# answer is known exactly.
#
#   twinwake setup-openfoam [solver ...]                  in the folder where twinwake looks by itself
#   tools/build_openfoam_solvers.sh FOLDER [solver ...]   -> FOLDER/bin/interFoam, FOLDER/lib/libventilatedWall.so,
#                                                            FOLDER/lib/libforcingZones.so,
#                                                            FOLDER/lib/libheldBody.so
#
# Solvers: interFoam (always), interIsoFoam, potentialFoam. About 40 s per solver on two cores, 0.4 GB of disk while it
# builds (JOBS=n sets the compiler processes). Three libraries are twinwake's own (15 s): walls that let water go where air
# can come (foam_cases/ventilated_wall), zones that absorb waves with an inlet at which waves enter
# (foam_cases/forcing_zones), and what holds a free hull until its release (foam_cases/held_body). No system setting is
# touched, and no root right is needed. Does nothing when all is there, the solvers start and belong to the installed
# package, and the libraries to their source. Needs: openfoam, dpkg-dev, g++, make, flex, libopenmpi-dev, zlib1g-dev.
set -euo pipefail

sources=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)/foam_cases
declare -A libraries_of=([ventilated_wall]=libventilatedWall.so [forcing_zones]=libforcingZones.so
                         [held_body]=libheldBody.so)
die() { echo "build_openfoam_solvers: $*" >&2; exit 1; }
[ $# -ge 1 ] && [[ $1 != -* ]] || { sed -n '2,/^set /{/^set /d;s/^# \{0,1\}//;p}' "$0"; exit 2; }
work=$(realpath -m -- "$1"); shift
case $work in *[!A-Za-z0-9._/+-]*) die "'$work': OpenFOAM's make files cannot live in a path with blanks or quotes; choose another folder";; esac
declare -A source_folder=([interFoam]=multiphase/interFoam [interIsoFoam]=multiphase/interIsoFoam [potentialFoam]=basic/potentialFoam)
solvers=(interFoam)
for s in "$@"; do
    [ -n "${source_folder[$s]:-}" ] || die "unknown solver '$s'; known: ${!source_folder[*]}"
    [ "$s" = interFoam ] || solvers+=("$s")
done

needed="openfoam dpkg-dev g++ make flex libopenmpi-dev zlib1g-dev bzip2"
command -v dpkg-query >/dev/null && command -v apt-get >/dev/null ||
    die "this system has no apt and so no package whose source could be built; load a release of openfoam.com or openfoam.org (source its etc/bashrc) and give the same command again"
package=$(dpkg-query -W -f '${db:Status-Status} ${Version}' openfoam 2>/dev/null) && [[ $package == "installed "* ]] ||
    die "the package 'openfoam' is not installed: sudo apt-get install --no-install-recommends $needed"
package=${package#* }
stamp="openfoam $package, __restrict__ off"

library_stamp() {  # of the source folder $1
    local also=()
    [ "$1" != forcing_zones ] || also=("$sources"/../waves/wave_{sum,components}.h)
    echo "$stamp, source $(cat "$sources/$1"/*.[CH] "${also[@]}" | sha256sum | cut -c1-16)"
}

missing_solvers() {  # of the wanted ones: not here, not made from the installed package, or not able to start
    local s
    for s in "${solvers[@]}"; do
        [ "$(cat "$work/stamp" 2>/dev/null)" = "$stamp" ] && [ -x "$work/bin/$s" ] &&
            WM_PROJECT_DIR=/usr/share/openfoam "$work/bin/$s" -help >/dev/null 2>&1 || echo "$s"
    done
}
missing_libraries() {
    local name
    for name in "${!libraries_of[@]}"; do
        [ "$(cat "$work/lib/$name.stamp" 2>/dev/null)" = "$(library_stamp "$name")" ] &&
            [ -f "$work/lib/${libraries_of[$name]}" ] || echo "$name"
    done
}
ready() { [ -z "$(missing_solvers)" ] && [ -z "$(missing_libraries)" ]; }
if ready; then echo "$work: ${solvers[*]} and twinwake's libraries are there ($stamp)"; exit 0; fi
for tool in dpkg-source g++ make flex mpicxx tar bzip2 xz flock; do
    command -v "$tool" >/dev/null || die "'$tool' is missing: sudo apt-get install --no-install-recommends $needed xz-utils util-linux"
done
echo "#include <zlib.h>" | g++ -E -x c++ - >/dev/null 2>&1 ||
    die "the header zlib.h is missing: sudo apt-get install --no-install-recommends $needed"
mkdir -p "$work" || die "$work cannot be made; choose another folder, or give the command as root"
free=$(df -Pk "$work" | awk 'NR == 2 { print int($4 / 1e6) }')
[ "$free" -ge 1 ] || die "less than 1 GB is free in $work; the build takes 0.4 GB and the package of sources 0.1 GB"

exec 9>"$work/.lock"
flock 9                      # two builds in one folder: the second waits and then finds the work done
if ready; then exit 0; fi
rm -rf "$work/build"
trap 'rm -rf "$work/build"' EXIT   # whatever ends it; what is whole has been moved out
mkdir -p "$work/build/lists/partial" "$work/build/bin" "$work/bin" "$work/lib"; cd "$work/build"
echo "fetching the source of openfoam ${package%+b*} (45 MB) and building ${solvers[*]} in $work (two minutes on two cores)"

# A private list of source packages, made from the system's own list of binary ones.
for f in /etc/apt/sources.list.d/debian.sources /etc/apt/sources.list.d/ubuntu.sources; do
    if [ -f "$f" ]; then sed 's/^Types:.*/Types: deb-src/' "$f" >>private.sources; fi
done
list=$work/build/private.sources
if [ ! -s "$list" ]; then
    list=$work/build/private.list
    sed -n 's/^deb /deb-src /p' /etc/apt/sources.list 2>/dev/null >"$list" || true
fi
apt=(apt-get -qq -o "Dir::Etc::sourcelist=$list" -o Dir::Etc::sourceparts=/dev/null -o "Dir::State::lists=$work/build/lists"
     -o APT::Sandbox::User="$(id -un)")
[ -s "$list" ] || die "neither /etc/apt/sources.list nor debian.sources or ubuntu.sources beside it names a place of packages, so none of their sources is known"
"${apt[@]}" update || die "the lists of sources could not be fetched, see above (network, proxy?)"
"${apt[@]}" source --download-only "openfoam=${package%+b*}" || die "the source of openfoam ${package%+b*} could not be fetched, see above"
mkdir tree
tar xf openfoam_*.orig.tar.* -C tree --strip-components=1
src=$work/build/tree

# What OpenFOAM's own make needs to know of the machine; libraries are the packaged ones.
platform=linux64Gcc
export WM_PROJECT=OpenFOAM WM_PROJECT_DIR=$src WM_PROJECT_USER_DIR=$work/build WM_PROJECT_VERSION=v1912 \
    WM_ARCH=linux64 WM_OSTYPE=POSIX WM_LABEL_SIZE=32 WM_LABEL_OPTION=Int32 WM_PRECISION_OPTION=DP \
    WM_COMPILER=Gcc WM_COMPILER_TYPE=system WM_COMPILER_LIB_ARCH=64 WM_COMPILE_OPTION=Opt WM_OPTIONS=$platform \
    WM_DIR=$src/wmake WM_MPLIB=SYSTEMOPENMPI WM_NCOMPPROCS="${JOBS:-2}"
export FOAM_APP=$src/applications FOAM_SOLVERS=$src/applications/solvers FOAM_SRC=$src/src FOAM_ETC=$src/etc \
    FOAM_MPI=openmpi-system FOAM_APPBIN=$work/build/bin FOAM_USER_APPBIN=$work/build/bin FOAM_USER_LIBBIN=$work/build/bin \
    FOAM_LIBBIN=$src/platforms/$platform/lib FOAM_EXT_LIBBIN=$src/platforms/$platform/lib
MPI_ARCH_PATH=$(dirname "$(mpicxx --showme:incdirs | tr ' ' '\n' | head -n 1)")
export MPI_ARCH_PATH PATH=$src/wmake:$src/bin:$PATH
export FOAM_EXTRA_CXXFLAGS="-D__restrict__= -w"   # the mending
mkdir -p "$src/platforms/$platform"
libraries=/usr/lib
[ -e /usr/lib/libfiniteVolume.so ] || libraries=/usr/lib/openfoam
ln -sfn "$libraries" "$src/platforms/$platform/lib"

log=$work/build.log; : >"$log"
( cd "$src/wmake/src" && make -s ) >>"$log" 2>&1 || die "wmake's own tools did not build, see $log"
( cd "$src/src"
  for d in */ */*/ */*/*/; do
      if [ -f "$d/Make/files" ]; then wmakeLnInclude -s "$d" || true; fi
  done ) >>"$log" 2>&1
for s in $(missing_solvers); do
    ( cd "$src/applications/solvers/${source_folder[$s]}" && wmake -s ) >>"$log" 2>&1 || die "$s did not build, see $log"
    mv "$work/build/bin/$s" "$work/bin/$s"
    echo "$work/bin/$s"
done
echo "$stamp" >"$work/stamp"
for name in $(missing_libraries); do
    # shellcheck disable=SC2086   # the mending is two words
    g++ -std=c++11 -m64 -pthread -O2 -fPIC -shared -ftemplate-depth-100 $FOAM_EXTRA_CXXFLAGS -DOPENFOAM=1912 -DWM_DP \
        -DWM_LABEL_SIZE=$WM_LABEL_SIZE -DNoRepository -I"$src/src/finiteVolume/lnInclude" \
        -I"$src/src/OpenFOAM/lnInclude" -I"$src/src/OSspecific/POSIX/lnInclude" -I"$src/src/meshTools/lnInclude" \
        -I"$src/src/sixDoFRigidBodyMotion/lnInclude" -I"$src/src/dynamicMesh/lnInclude" -I"$sources/../waves" \
        -o "$work/build/${libraries_of[$name]}" "$sources/$name"/*.C \
        -L"$FOAM_LIBBIN" -Wl,--as-needed -lsixDoFRigidBodyMotion >>"$log" 2>&1 ||
        die "$sources/$name did not build, see $log; interFoam runs without it, and \`twinwake doctor\` says what it then cannot do"
    mv "$work/build/${libraries_of[$name]}" "$work/lib/${libraries_of[$name]}"
    library_stamp "$name" >"$work/lib/$name.stamp"
done
ready || die "the solvers were built but do not start, see $log and: $work/bin/interFoam -help"
echo "$work: ${solvers[*]} and twinwake's libraries built ($stamp)"
