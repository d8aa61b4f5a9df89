#!/usr/bin/env bash
# Fuzzes the program's readers with libFuzzer under the address and undefined-behaviour sanitizers.
#
#   tools/fuzz.sh [SECONDS] [READER...]      SECONDS for each reader, 600 unless given; all readers unless some are named
#
# Builds build-fuzz with Clang (./bootstrap.sh deps installs it). Inputs that reach code which no seed of
# tests/robustness/readers/corpus reaches are kept in build-fuzz/corpus, from which the next call goes on. One that crashes
# a reader, hangs it or takes more than 2 GB is kept in build-fuzz/found. Prints for each reader how many inputs it had in
# what time; exit status 1 when any did harm.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

seconds=600
if [[ ${1:-} =~ ^[0-9]+$ ]]; then seconds=$1; shift; fi
seeds=tests/robustness/readers/corpus
readers=("$@")
[ ${#readers[@]} -gt 0 ] || mapfile -t readers < <(cd "$seeds" && printf '%s\n' *)

cmake --preset fuzz >/dev/null
cmake --build --preset fuzz
scratch=$(TMPDIR=$([ -w /dev/shm ] && echo /dev/shm || echo "${TMPDIR:-/tmp}") mktemp -d)
trap 'rm -rf "$scratch"' EXIT
# HDF5 keeps what it cannot read (tools/lsan.supp), which grows with the inputs: leaks are searched in the unit tests.
export TMPDIR=$scratch ASAN_OPTIONS=strict_string_checks=1:detect_leaks=0 UBSAN_OPTIONS=halt_on_error=1:print_stacktrace=1
status=0
for reader in "${readers[@]}"; do
    mkdir -p "build-fuzz/corpus/$reader" build-fuzz/found
    log=build-fuzz/found/$reader.log
    result=sound more=()
    if [ "$reader" = scene ]; then  # a tyre's calibration takes fifteen seconds under the sanitizers
        more=("$scratch/studies")
        mkdir "${more[0]}"
        grep -L '"tyre"' studies/*.toml | xargs cp -t "${more[0]}"
    fi
    # A child of VTK's readers has 60 s (base/trial.h).
    build-fuzz/tests/fuzz/readers/fuzz_readers --reader="$reader" -max_total_time="$seconds" -timeout=90 \
        -rss_limit_mb=2048 -malloc_limit_mb=1024 -use_value_profile=1 -print_final_stats=1 \
        -artifact_prefix="build-fuzz/found/$reader-" "build-fuzz/corpus/$reader" "$seeds/$reader" "${more[@]}" >"$log" 2>&1 ||
        { result="FOUND, see $log"; status=1; }
    printf '%-18s %9s inputs in %5s s, %6s edges: %s\n' "$reader" \
        "$(sed -n 's/^stat::number_of_executed_units: *//p' "$log")" "$seconds" \
        "$(sed -n 's/.* cov: \([0-9]*\) .*/\1/p' "$log" | tail -1)" "$result"
done
exit $status
