#!/usr/bin/env bash
# What the GPU of this machine makes of the particles, in one go: that the strict kernels take the host's steps bit for bit
# (the tests of tests/unit/sph_solver/on_device_test.cpp on the real device), that NVIDIA's compute-sanitizer finds nothing
# where it is installed, and how fast it is over the number of particles, beside the card's own peaks. Leaves
# OUT/gpu_evidence.txt, with the date, the card and its driver.
#
#   tools/gpu_evidence.sh OUT [PROGRAM TESTS]    folder; twinwake and unit_sph_solver (those of build/)
#
# Exit status: 0 all that could be asked was right, 1 something was not.
set -uo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.." || exit 1
[ $# -ge 1 ] || { sed -n '2,9p' "${BASH_SOURCE[0]}" | cut -c3-; exit 2; }
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
ask strict_kernels_equal_the_host on_device 1 'OnDevice.*'
# What no kernel may do is read what nobody wrote; copies to the host take the padding of structs along, which nobody writes.
reads_what_was_written() {
    on_device 1 "$1" compute-sanitizer --tool initcheck --print-limit 100000
    ! grep -q 'Uninitialized __[a-z]*__ memory read' "$out/initcheck.txt"
}
if command -v compute-sanitizer >/dev/null; then
    for tool in memcheck racecheck synccheck; do
        ask "$tool" on_device 1 'OnDevice.WhatTheHostChanges*' compute-sanitizer --tool "$tool" --error-exitcode 1
    done
    ask initcheck reads_what_was_written 'OnDevice.WhatTheHostChanges*'
fi

say "particles  h/dp  million evaluations/s, all  between lists  bytes a particle, on the device"
for h in 1.55 2; do
    for n in ${GPU_EVIDENCE_PARTICLES:-100000 1000000 10000000 50000000}; do
        if "$program" bench --device gpu --particles "$n" --h-over-dp "$h" --seconds 3 >"$out/bench_${n}_$h.txt" 2>&1; then
            say "$(awk -v h="$h" '/ neighbours each/ { n = $1 } /million particle/ { all = $1; for (k = 2; k <= NF; ++k) if ($k == "between") between = $(k - 2) }
                   / bytes per particle/ { b = $1 ", " $5; sub(/.*at most: /, ""); peak = $0 } END { printf "%9d  %4s  %8s  %8s  %9s   (%s)", n, h, all, between, b, peak }' "$out/bench_${n}_$h.txt")"
        else
            say "$n $h: $(tail -1 "$out/bench_${n}_$h.txt")"
            status=1
        fi
    done
done
exit $status
