#!/usr/bin/env bash
# What the GPU of this machine makes of the particles, in one go:
# - that the strict kernels take the host's steps bit for bit: the tests OnDevice.* of unit_sph_solver on the real device,
#   with a line each for plates that bend, for air, and for all others;
# - that NVIDIA's compute-sanitizer finds nothing, where it is installed;
# - doctor's self-test;
# - how fast it is and what memory it takes over the number of particles, beside the card's own peaks;
# - a profile of the sweeps, where ncu is installed;
# - the seaplane at the published resolution and two coarser sizes, with the interval that follows from them: three
#   quarters of an hour on an H100. GPU_EVIDENCE_SCENE names another scene, or none if it is empty;
#   GPU_EVIDENCE_DURATION shortens it.
# Leaves OUT/gpu_evidence.txt, with the date, the card and its driver, and what each part printed beside it.
#
#   tools/gpu_evidence.sh OUT [PROGRAM TESTS]    folder; twinwake and unit_sph_solver (those of build/)
#
# Exit status: 0 all that could be asked was right, 1 something was not.
set -uo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.." || exit 1
[ $# -ge 1 ] && [[ $1 != -* ]] || { sed -n '2,16p' "${BASH_SOURCE[0]}" | cut -c3-; exit 2; }
out=$1 program=${2:-build/twinwake} tests=${3:-build/tests/unit/sph_solver/unit_sph_solver}
mkdir -p "$out" || exit 1
table=$out/gpu_evidence.txt
library=${TWINWAKE_LIBCUDA:-libcuda.so.1}
export OMP_WAIT_POLICY=passive
status=0
say() { echo "$*" | tee -a "$table"; }

: >"$table"
say "$(date -u +%Y-%m-%d) $("$program" --version | head -1)"
command -v nvidia-smi >/dev/null && say "$(nvidia-smi --query-gpu=name,driver_version --format=csv,noheader)"

# ask NAME COMMAND...: one line of the table, its output in OUT/NAME.txt.
ask() {
    local name=$1 from=$SECONDS
    shift
    if "$@" >"$out/$name.txt" 2>&1; then say "$name: passed ($((SECONDS - from)) s)"; else say "$name: FAILED, see $name.txt"; status=1; fi
}
on_device() { TWINWAKE_TEST_LIBCUDA=$library TWINWAKE_STRICT_KERNELS=$1 "${@:3}" "$tests" --gtest_filter="$2"; }
# The same, and some of them there were.
some_on_device() { on_device 1 "$1" | tee /dev/stderr | grep -c '^\[  PASSED  \] [1-9]' >/dev/null; }
plates='OnDevice.*Plate*:OnDevice.*Flap*' air='OnDevice.*Air*'
ask strict_kernels_equal_the_host_with_plates some_on_device "$plates"
ask strict_kernels_equal_the_host_with_air some_on_device "$air"
ask strict_kernels_equal_the_host_with_all_else some_on_device "OnDevice.*-$plates:$air"
# What no kernel may do is read what nobody wrote; copies to the host take the padding of structs along, which nobody writes.
reads_what_was_written() {
    on_device 1 "$1" compute-sanitizer --tool initcheck --print-limit 100000
    ! grep -q 'Uninitialized __[a-z]*__ memory read' "$out/initcheck.txt"
}
sanitized='OnDevice.WhatTheHostChanges*'
if command -v compute-sanitizer >/dev/null; then
    for tool in memcheck racecheck synccheck; do
        ask "$tool" on_device 1 "$sanitized" compute-sanitizer --tool "$tool" --error-exitcode 1
    done
    ask initcheck reads_what_was_written "$sanitized"
    ask memcheck_plate_air_and_sizes on_device 1 'OnDevice.AirUnderAPlate*:OnDevice.APlateBendsUnderWaterOfTwo*' \
        compute-sanitizer --tool memcheck --error-exitcode 1
else
    say "compute-sanitizer: not installed"
fi

# doctor judges the whole machine; this is about the line of the GPU.
gpu_is_sound() { "$program" doctor; grep -q 'sound: error' "$out/doctor.txt"; }
ask doctor gpu_is_sound

say "particles  h/dp  million evaluations/s, all  between lists  bytes a particle, on the device; GB there"
for h in 1.55 2; do
    for n in ${GPU_EVIDENCE_PARTICLES:-100000 1000000 10000000 50000000}; do
        if "$program" bench --device gpu --particles "$n" --h-over-dp "$h" --seconds 3 >"$out/bench_${n}_$h.txt" 2>&1; then
            say "$(awk -v h="$h" '/ neighbours each/ { n = $1 } /million particle/ { all = $1; for (k = 2; k <= NF; ++k) if ($k == "between") between = $(k - 2) }
                   / bytes per particle/ { b = $1 ", " $5; there = n * $5 / 1e9; sub(/.*at most: /, ""); peak = $0 }
                   END { printf "%9d  %4s  %8s  %8s  %9s; %.3g   (%s)", n, h, all, between, b, there, peak }' "$out/bench_${n}_$h.txt")"
        else
            say "$n $h: $(tail -1 "$out/bench_${n}_$h.txt")"
            status=1
        fi
    done
done

if command -v ncu >/dev/null; then
    ask profile ncu --kernel-name 'regex:tw_(first|second)_sweep' --launch-skip 20 --launch-count 2 \
        --section SpeedOfLight --section WarpStateStats --section MemoryWorkloadAnalysis --section Occupancy \
        "$program" bench --device gpu --particles "${GPU_EVIDENCE_PROFILED:-1000000}" --h-over-dp 1.55 --seconds 1
else
    say "ncu: not installed"
fi

scene=${GPU_EVIDENCE_SCENE-studies/seaplane_80_paper.toml}
if [ -n "$scene" ]; then
    ask three_sizes "$program" ladder "$scene" --method sph --device gpu --levels 3 --no-variations --no-fill \
        ${GPU_EVIDENCE_DURATION:+--duration "$GPU_EVIDENCE_DURATION"} --overwrite --out "$out/three_sizes"
    grep -i -E 'lift|drag' "$out/three_sizes.txt" | tee -a "$table"
fi
exit $status
