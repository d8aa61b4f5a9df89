#!/usr/bin/env bash
# What the kernels for a GPU have to be, read off their PTX: no kernel calls a function; the loops over pairs and the search
# for neighbours keep nothing in local memory; no loop over pairs computes in double precision. Where the toolkit's ptxas is
# found, the pair loops take at most 64 registers a thread for compute capability 9.0, and the bytes that they spill are shown
# (128 at most: half of the threads that a multiprocessor can hold are worth more than no spills, docs/decisions/067).
#
#   tools/check_kernels.sh FILE.ptx
#
# A line for each fault; exit status 0 none, 1 some.
set -uo pipefail
[ $# = 1 ] && [ -r "$1" ] || { sed -n '2,10p' "${BASH_SOURCE[0]}" | cut -c3-; exit 2; }
status=0
pairs='tw_first_pair_loop|tw_second_pair_loop|tw_extrapolate|tw_interpolate|tw_near_air'
pairs+='|tw_meet_other|tw_press_other|tw_velocity_at_walls|tw_friction|tw_strain_rate|tw_colour_gradient|tw_curvature'
faults=$(awk -v pairs="^($pairs)$" -v flat="^($pairs|tw_prune|tw_search)$" '
    /\.entry/ { split($3, name, "("); kernel = name[1]; ++kernels }
    /^[ \t]*call/ { print kernel ": calls a function, line " NR }
    /\.local/ && kernel ~ flat { print kernel ": uses local memory, line " NR }
    /(add|sub|mul|fma|div|sqrt|rcp)[.a-z]*\.f64/ && kernel ~ pairs { print kernel ": computes in double precision, line " NR }
    END { if (kernels < 30) print "only " kernels " kernels" }' "$1")
[ -z "$faults" ] || { echo "$faults"; status=1; }

ptxas=$(command -v ptxas || ls /usr/local/cuda/bin/ptxas 2>/dev/null || true)
if [ -z "$ptxas" ]; then
    echo "no ptxas: registers were not counted"
    exit $status
fi
"$ptxas" -arch=sm_90 -v "$1" -o /dev/null 2>&1 | awk -v pairs="^($pairs)$" '
    /Compiling entry function/ { split($0, part, "\047"); kernel = part[2] }
    /spill stores/ { spill[kernel] = $5 }
    /Used [0-9]+ registers/ { for (k = 1; k <= NF; ++k) if ($k == "Used") registers[kernel] = $(k + 1) }
    END {
        for (kernel in registers)
            if (kernel ~ pairs) {
                ++seen
                printf "%s: %d registers, %d bytes spilled\n", kernel, registers[kernel], spill[kernel]
                if (registers[kernel] > 64 || spill[kernel] > 128) { print kernel ": too many"; bad = 1 }
            }
        if (seen < 4) { print "ptxas said nothing of the pair loops"; bad = 1 }
        exit bad
    }' || status=1
exit $status
