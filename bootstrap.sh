#!/usr/bin/env bash
# From a bare Debian 12 / Ubuntu machine to a built, tested or demonstrated twinwake. See --help.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"
root=$PWD

# ---------------------------------------------------------------------------------------------------------------------
# What has to be installed: the one list.
build_packages=(
    cmake ninja-build g++ ccache git make
    libvtk9-dev libeigen3-dev libhdf5-dev libfmt-dev libtomlplusplus-dev libcli11-dev nlohmann-json3-dev libboost-dev
    libssl-dev zlib1g-dev libgtest-dev valgrind openmpi-bin libopenmpi-dev
    libocct-data-exchange-dev                         # hulls from STEP and IGES
    libegl-dev libegl1 libegl-mesa0 libgl1-mesa-dri   # pictures without a display
)
# Used if it is there: npm, whose packages make the report's plots and 3-D view (compare/README.md). Debian's own brings 355
# packages, so it is not asked for.
# interFoam, and what its mended build from the distribution's source package takes (tools/build_openfoam_solvers.sh).
openfoam_packages=(openfoam dpkg-dev flex)
# A Slurm on one host, for the tests of studies on a cluster; without it they are skipped. Clang with its libFuzzer and
# its OpenMP, for tools/fuzz.sh. For the tests of the Python package: h5py, xarray; what films and the gallery are drawn
# with; and a display in memory for ParaView, which tools/unpack_paraview.sh fetches (73 MB), since Debian cannot install
# it beside libvtk9-dev.
test_packages=(
    slurm-wlm munge clang libclang-rt-dev libomp-dev
    python3-h5py python3-numpy python3-xarray python3-matplotlib python3-pil ffmpeg xvfb
)
# ---------------------------------------------------------------------------------------------------------------------

usage() {
    cat <<'END'
usage: ./bootstrap.sh COMMAND [options]

commands
  demo     install what is missing, build, run the small paired planing study, leave runs/demo/report.html
  test     install what is missing, build, run all tests
  build    install what is missing, build: the program is build/twinwake
  deps     only install what is missing

options
  --no-openfoam   without OpenFOAM: neither installed nor built; the paired parts are left out
  --no-install    install nothing and ask nothing: the packages are known to be there
  --werror        compiler warnings are errors
  --jobs N        build with N jobs (default: one per core, and at least 2 GB of memory for each)
  -h, --help      this text

Exit status: 0 done; 2 wrong usage, or something has to be installed first (it says what); 1 a build or a test failed.
END
}

say() { printf '\n== %s\n' "$*"; }
die() { printf 'bootstrap.sh: %s\n' "$*" >&2; exit 2; }

command=""
with_openfoam=1
may_install=1
werror=OFF
jobs=""
while [ $# -gt 0 ]; do
    case $1 in
        demo | test | build | deps)
            [ -z "$command" ] || die "two commands, '$command' and '$1': give one"
            command=$1 ;;
        --no-openfoam) with_openfoam=0 ;;
        --no-install) may_install=0 ;;
        --werror) werror=ON ;;
        --jobs)
            shift
            [[ ${1:-} =~ ^[1-9][0-9]*$ ]] || die "--jobs takes a whole number, found '${1:-}'"
            jobs=$1 ;;
        -h | --help) usage; exit 0 ;;
        *) usage >&2; die "unknown argument '$1'" ;;
    esac
    shift
done
[ -n "$command" ] || { usage >&2; exit 2; }

cores=$(nproc)
if [ -z "$jobs" ]; then
    memory_jobs=$(awk '/^MemAvailable:/ { print int($2 / 2e6) }' /proc/meminfo)
    jobs=$((memory_jobs < cores ? memory_jobs : cores))
    [ "$jobs" -ge 1 ] || jobs=1
fi

# --- packages --------------------------------------------------------------------------------------------------------

# An OpenFOAM environment that the user has loaded is used as it is; the distribution's is then not needed.
own_openfoam() {
    [ -n "${WM_PROJECT_DIR:-}" ] && [ "$WM_PROJECT_DIR" != /usr/share/openfoam ] &&
        { command -v interFoam || command -v foamRun; } >/dev/null 2>&1
}

wanted_packages() {
    printf '%s\n' "${build_packages[@]}"
    if [ "$with_openfoam" = 1 ] && ! own_openfoam; then printf '%s\n' "${openfoam_packages[@]}"; fi
    if [ "$command" = test ] || [ "$command" = deps ]; then printf '%s\n' "${test_packages[@]}"; fi
    if [ -e /proc/driver/nvidia ]; then echo clang; fi  # makes the kernels of a GPU
    # The sources are C++20 as GCC 12 knows it; Ubuntu 22.04's default is GCC 11.
    if [ "${ID:-}" = ubuntu ] && [ "${VERSION_ID:-}" = 22.04 ]; then echo g++-12; fi
}

missing_packages() {
    wanted_packages | while read -r package; do
        status=$(dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null || true)
        [ "$status" = installed ] || printf '%s\n' "$package"
    done
}

# Says what to install where this script cannot, and stops.
tell_and_stop() {
    printf 'bootstrap.sh: %s\nInstall this first, then run the same command again:\n\n' "$1" >&2
    printf '    %s\n\n' "$2" >&2
    printf '(Already there under other names? Then: ./bootstrap.sh %s --no-install)\n' "$command" >&2
    exit 2
}

install_packages() {
    [ -r /etc/os-release ] && . /etc/os-release
    if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
        tell_and_stop "${PRETTY_NAME:-this system} has no apt." \
            "your system's packages of (Debian names): $(wanted_packages | tr '\n' ' ')"
    fi
    local missing
    mapfile -t missing < <(missing_packages)
    if [ ${#missing[@]} = 0 ]; then
        echo "packages: all there"
        return
    fi
    case "${ID:-} ${VERSION_ID:-}" in
        "debian 12" | "ubuntu 22.04" | "ubuntu 24.04") ;;
        *) echo "note: ${PRETTY_NAME:-this system} is none of Debian 12, Ubuntu 22.04, Ubuntu 24.04; trying all the same" ;;
    esac

    local sudo=()
    if [ "$(id -u)" != 0 ]; then
        if command -v sudo >/dev/null && { sudo -n true 2>/dev/null || [ -t 0 ]; }; then
            sudo=(sudo)
        else
            tell_and_stop "packages are missing, and only root may install them." \
                "apt-get install --no-install-recommends ${missing[*]}"
        fi
    fi
    local apt=("${sudo[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -q -y --no-install-recommends)
    say "installing ${#missing[@]} packages: ${missing[*]}"
    # The package lists are fetched only when they are absent or too old to name what is wanted.
    if ! apt-get -s -qq --no-install-recommends install "${missing[@]}" >/dev/null 2>&1; then
        "${apt[@]}" update
        local unknown=()
        for package in "${missing[@]}"; do
            [[ $(apt-cache policy "$package") == *"Candidate: "[!\(]* ]] || unknown+=("$package")
        done
        [ ${#unknown[@]} = 0 ] || tell_and_stop "${PRETTY_NAME:-this system} does not package: ${unknown[*]}." \
            "these from source (Ubuntu 22.04 lacks toml++ 3 only), or take Debian 12 or Ubuntu 24.04, which have all"
    fi
    if ! "${apt[@]}" install "${missing[@]}" </dev/null; then
        "${apt[@]}" update
        "${apt[@]}" install "${missing[@]}" </dev/null ||
            tell_and_stop "apt-get failed, see above." "apt-get install --no-install-recommends ${missing[*]}"
    fi
}

# --- build -----------------------------------------------------------------------------------------------------------

build_twinwake() {
    say "building with $jobs jobs"
    if [ -z "${CXX:-}" ] && command -v g++-12 >/dev/null && [ "$(g++ -dumpversion | cut -d. -f1)" -lt 12 ]; then
        export CC=gcc-12 CXX=g++-12
    fi
    cmake --preset release -DTWINWAKE_WERROR="$werror"
    local targets=()
    if [ "$command" = demo ]; then targets=(--target twinwake); fi  # a first look need not wait for the tests
    cmake --build build -j "$jobs" "${targets[@]}"
    echo "program: build/twinwake"
}

# The distribution's interFoam is miscompiled; `doctor` tells a sound one from a faulty one by an exact answer.
openfoam_is_sound() { build/twinwake doctor --quiet >/dev/null 2>&1; }

provide_openfoam() {
    [ "$with_openfoam" = 1 ] || { echo "OpenFOAM: left out (--no-openfoam)"; return; }
    if openfoam_is_sound; then
        echo "OpenFOAM: a sound interFoam is there"
        # Its libraries of walls and zones may be absent or of an earlier source; interFoam runs without them, and says so.
        if [ -x .openfoam/bin/interFoam ]; then
            JOBS=$jobs tools/build_openfoam_solvers.sh "$root/.openfoam" ||
                echo "note: interFoam is without twinwake's libraries of walls and zones; streams that need zones are refused"
        fi
        return
    fi
    say "building interFoam from the distribution's source into .openfoam (about two minutes, once)"
    JOBS=$jobs tools/build_openfoam_solvers.sh "$root/.openfoam"
    openfoam_is_sound || { build/twinwake doctor || true; die "no sound OpenFOAM after the build, see above"; }
}

# ParaView, for the test of its script; what cannot be had skips that test.
provide_paraview() {
    if [ "$may_install" = 1 ] && ! command -v pvpython >/dev/null; then
        tools/unpack_paraview.sh .paraview || echo "note: no ParaView: the test of tools/paraview_both.py is skipped"
    fi
}

# --- commands --------------------------------------------------------------------------------------------------------

run_tests() {
    # Side by side, those that start a solver as well: most of them use one core, and none asserts a speed. One more than
    # there are cores, since some wait: for a disk, a scheduler, the end of another run.
    local at_once=$((jobs + 1))
    # The test programs lie deeper than build/twinwake, beside which the mended solvers are looked for.
    if [ -d .openfoam/bin ]; then export TWINWAKE_OPENFOAM_BIN=$root/.openfoam/bin; fi
    say "tests, $at_once at a time"
    # unit tests in shares: what the label "unit" holds one by one
    ctest --test-dir build --output-on-failure --no-tests=error -j "$at_once" --label-exclude '^unit$'
}

run_demo() {
    local methods=()
    if [ "$with_openfoam" = 0 ]; then methods=(--method sph); fi
    say "the demo: a small planing hull in both methods"
    build/twinwake run studies/demo.toml --out runs/demo --overwrite "${methods[@]}"
    if [ -f runs/demo/report.html ]; then
        printf '\nThe report, one file to open in a browser: %s/runs/demo/report.html\n' "$root"
    fi
}

if [ "$may_install" = 1 ]; then install_packages; fi
if [ "$command" = test ] || [ "$command" = deps ]; then provide_paraview; fi
[ "$command" != deps ] || exit 0
build_twinwake
provide_openfoam
case $command in
    test) run_tests ;;
    demo) run_demo ;;
esac
