#!/usr/bin/env bash
# Runs a set of short particle runs with two versions of the program and compares their run records bit by bit: every table
# (forces, samples, pressure, height), the raster frames, the hull's pressure and the certificate. For changes that are to
# leave all numbers alone.
#
#   tools/same_bits.sh OLD NEW [RUN...]                             two commits, e.g. tools/same_bits.sh main HEAD
#   tools/same_bits.sh --programs OLD_PROGRAM NEW_PROGRAM [RUN...]  two programs that are built already
#   tools/same_bits.sh --list                                       names of the runs; without RUN all are made
#
# One line per run: its name, and "same" with the rows compared, or "DIFFERENT" with the first difference (table, column, row
# from 0, both values). Exit status: 0 all same, 1 a difference, 2 a run or a build failed. Commits are built in
# build/same_bits/COMMIT (JOBS=n: compiler processes, 2); the program of a commit is kept there. Both programs run at the same
# time, on one thread each where a run does not say otherwise: about a minute on two cores.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source=$PWD

die() { echo "same_bits.sh: $*" >&2; exit 2; }

# --- the runs: run NAME SCENE [options of `twinwake run`], in a table that is gone through once -------------------------------

# A small planing prism in a stream: particles enter, leave and meet a hull. Arguments are further lines of the scene.
prism() {
    cat <<-'END'
	[hull]
	shape    = "prismatic"
	length   = "2 m"
	beam     = "0.5 m"
	deadrise = "20 deg"
	trim     = "5 deg"
	draft    = "0.1 m"
	half     = true
	[motion]
	kind  = "stream"
	speed = "5 m/s"
	[domain]
	ahead  = "0.4 m"
	behind = "0.4 m"
	side   = "0.5 m"
	below  = "0.4 m"
	[resolution]
	spacing   = "0.05 m"
	near_hull = "0.05 m"
	[sampling]
	interval = "0.05 s"
	[run]
	duration   = "0.3 s"
	checkpoint = "0.1 s"
	END
    printf '%s\n' "$@"
}
study() { cat "studies/$1.toml"; printf '%s\n' "${@:2}"; }  # a ready scene

all_runs() {
    run planing_prism        "$(study planing_prism)" --scale 4 --duration 0.15s
    run whole_hull_2_threads "$(prism | sed 's/^half .*/half = false/')" --threads 2
    run seaplane             "$(study seaplane_30)" --scale 5.6569 --duration 0.25s
    run levels_hull          "$(study planing_prism_levels)" --scale 2 --duration 0.03s --threads 2
    run levels_body          "$(study cylinder_entry)" --near-hull 20mm --duration 0.02s
    run spheric02            "$(study spheric02)" --near-hull 80mm --duration 1s
    run spheric02_2_threads  "$(study spheric02)" --near-hull 60mm --duration 0.3s --threads 2
    run still_tank           "$(study still_tank)" --near-hull 70mm --duration 0.5s
    run dam_break_2d         "$(study dam_break_2d)" --scale 2 --duration 0.3s
    run surface_tension      "$(study cup)" --scale 2 --duration 0.1s
    run air                  "$(study pocket)" --scale 2 --duration 0.5s --effect air=on
    run no_slip              "$(study spheric02)" --near-hull 80mm --duration 0.6s --effect viscosity=on --effect no_slip=on
    run turbulence           "$(prism)" --effect viscosity=on --effect no_slip=on --effect turbulence=on
    run cavitation_damping   "$(prism)" --speed 20m/s --duration 0.08s --effect cavitation=on --effect acoustic_damping=on
    run damping_layers       "$(prism)" --effect damping_layers=on
    run moving_tank          "$(study sloshing)" --near-hull 5mm --duration 0.6s
    run floating_body        "$(study floating_box)" --near-hull 10mm --duration 0.3s
    run free_hull            "$(prism | sed 's/^draft .*/&\nfree = ["heave"]\nmass = "150 kg"\nrelease = "0.1 s"/')"
    run elastic_shell        "$(study elastic_gate)" --near-hull 2mm --duration 0.04s
    run elastic_penalty      "$(study elastic_gate | sed 's/^skin .*/coupling = "penalty"/')" --near-hull 2mm --duration 0.02s
    run elastic_rehearsed    "$(study elastic_gate | sed 's/^margin .*/coupling_iterations = 3/')" --near-hull 2mm --duration 0.02s
    run elastic_solid        "$(study tyre_drop_30)" --near-hull 8mm --duration 2ms
    run tension_control      "$(prism)" --effect tension_control=on
    run no_shifting          "$(prism)" --effect shifting=off
    local scheme
    for scheme in symplectic_euler predictor_corrector rk4_frozen_diffusion kick_drift_kick; do
        run "$scheme"        "$(prism '[sph]' "scheme = \"$scheme\"")"
    done
    run tait                 "$(study dam_break_2d '[sph]' 'equation_of_state = "tait"')" --scale 2 --duration 0.2s
    run mie_grueneisen       "$(study dam_break_2d '[sph]' 'equation_of_state = "mie_grueneisen"')" --scale 2 --duration 0.2s
    resumed resumed_hull     "$(prism)" 0.2s 0.3s
    resumed resumed_air      "$(study pocket)" 0.05s 0.1s --scale 2 --effect air=on
    resumed resumed_body     "$(study floating_box)" 0.1s 0.2s --near-hull 10mm
    resumed resumed_elastic  "$(study elastic_gate)" 0.02s 0.03s --near-hull 2mm
    resumed resumed_effects  "$(prism)" 0.1s 0.2s --effect viscosity=on --effect turbulence=on --effect damping_layers=on
}

# --- what is done with them ----------------------------------------------------------------------------------------------------

# program_run PROGRAM FOLDER [options]: one particle run of FOLDER/../scene.toml.
program_run() {
    local program=$1 folder=$2 options=(--threads 1)
    shift 2
    [[ " $* " != *" --threads "* ]] || options=()
    # older versions have no twins, and do not know the option
    if "$program" run --help | grep -q -e --no-twins; then options+=(--no-twins); fi
    # a cache of its own: no run may learn from another how fast this machine is
    XDG_CACHE_HOME=$work/cache OMP_WAIT_POLICY=passive nice "$program" run "${folder%/*}/scene.toml" --method sph \
        --out "$folder" --quiet "${options[@]}" "$@" >>"$folder.log" 2>&1
}

# both NAME DURATIONS [options]: with both programs, resumed after each duration but the last; then the comparison.
both() {
    local name=$1 durations=$2 version status=0
    shift 2
    local pids=()
    for version in old new; do
        (
            again=()
            for duration in $durations; do
                length=(); [ "$duration" = scene ] || length=(--duration "$duration")
                program_run "${programs[$version]}" "$work/$name/$version" "${length[@]}" "${again[@]}" "$@" || exit 1
                again=(--resume)
            done
        ) &
        pids+=($!)
    done
    for version in old new; do
        wait "${pids[0]}" || { echo "$name: the $version program failed: $(tail -n 3 "$work/$name/$version.log" | tr '\n' ' ')"; status=2; }
        pids=("${pids[@]:1}")
    done
    if [ "$status" = 0 ]; then
        printf '%-22s ' "$name"
        "$same_record" "$work/$name/old/sph/record.h5" "$work/$name/new/sph/record.h5" || status=$?
    fi
    if [ "$status" -gt "$worst" ]; then worst=$status; fi
}

wanted() { [ ${#only[@]} = 0 ] || [[ " ${only[*]} " == *" $1 "* ]]; }
prepare() {  # NAME SCENE: whether this run is wanted; its scene file is there then
    known+=("$1")
    [ "$list" = 0 ] && wanted "$1" || return 1
    mkdir -p "$work/$1"
    printf '%s\n' "$2" >"$work/$1/scene.toml"
}
run() { if prepare "$1" "$2"; then both "$1" scene "${@:3}"; fi; }
resumed() { if prepare "$1" "$2"; then both "$1" "$3 $4" "${@:5}"; fi; }  # NAME SCENE FIRST_DURATION DURATION [options]

# program_of COMMIT: builds its program, once, and prints the path.
program_of() {
    local commit folder
    commit=$(git rev-parse --verify --quiet "$1^{commit}") || die "'$1' is no commit"
    folder=$source/build/same_bits/$commit
    if [ ! -x "$folder/twinwake" ]; then
        git worktree prune
        rm -rf "$folder"
        git worktree add --quiet --detach "$folder/source" "$commit" >&2
        export CCACHE_BASEDIR=$folder/source CCACHE_NOHASHDIR=1
        { cmake -S "$folder/source" -B "$folder/source/build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DTWINWAKE_TESTS=OFF &&
            nice cmake --build "$folder/source/build" -j "${JOBS:-2}" --target twinwake; } >"$folder/build.log" 2>&1 ||
            die "$1 does not build: see $folder/build.log"
        cp "$folder/source/build/twinwake" "$folder/twinwake"
        git worktree remove --force "$folder/source"
    fi
    echo "$folder/twinwake"
}

declare -A programs
only=() known=() worst=0 list=0 are_programs=0
case ${1:-} in
    --list) list=1 ;;
    --programs) are_programs=1; shift ;;
    -h | --help) sed -n '2,/^set /{/^set /d;s/^# \{0,1\}//;p}' "$0"; exit 0 ;;
esac
if [ "$list" = 1 ]; then all_runs; printf '%s\n' "${known[@]}"; exit 0; fi
[ $# -ge 2 ] || die "expected two commits, or --programs and two programs (--help says more)"
old=$1 new=$2
shift 2
only=("$@")

work=$(mktemp -d "${TMPDIR:-/tmp}/same_bits.XXXXXX")
trap 'rm -rf "$work"' EXIT
[ -f build/build.ninja ] || cmake --preset release >"$work/build.log" || die "$(tail "$work/build.log")"
nice cmake --build build -j "${JOBS:-2}" --target same_record >"$work/build.log" 2>&1 || die "same_record does not build: $(tail "$work/build.log")"
same_record=$(find build -name same_record -type f -perm -u+x | head -n 1)
if [ "$are_programs" = 1 ]; then
    for program in "$old" "$new"; do [ -x "$program" ] || die "'$program' is no program"; done
    programs=([old]=$(realpath "$old") [new]=$(realpath "$new"))
else
    programs[old]=$(program_of "$old")
    programs[new]=$(program_of "$new")
fi

# Variants of the pair loops round differently: both programs use the same one, which every version knows.
if [ -z "${TWINWAKE_ISA:-}" ]; then
    TWINWAKE_ISA=baseline
    grep -qw avx2 /proc/cpuinfo && TWINWAKE_ISA=avx2
    grep -qw avx512vl /proc/cpuinfo && TWINWAKE_ISA=avx512
    export TWINWAKE_ISA
fi
all_runs
for name in "${only[@]}"; do
    [[ " ${known[*]} " == *" $name "* ]] || die "there is no run '$name'; known: ${known[*]}"
done
exit "$worst"
