#!/usr/bin/env bash
# Runs the long validation cases with build/twinwake and prints the rows of their pages in docs, each with the command
# that made it.
#
#   tools/validation.sh [--method sph|fvm|both] [--out FOLDER] [--rows-only] [CASE...]
#
# Cases: still_tank empty_channel dam_break_2d spheric02 planing_prism seaplane_30 seaplane_80; without any: all but the
# seaplanes, which take hours. Runs lie in FOLDER (runs/validation) and are resumed, or left alone when finished, if the
# script is started again. --rows-only runs nothing and prints what is there. Needs: jq.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

out=runs/validation method=both rows_only=0 cases=()
while [ $# -gt 0 ]; do
    case $1 in
        --method) method=${2:?--method takes sph, fvm or both}; shift ;;
        --out) out=${2:?--out takes a folder}; shift ;;
        --rows-only) rows_only=1 ;;
        -h | --help) sed -n '2,/^set /{/^set /d;s/^# \{0,1\}//;p}' "$0"; exit 0 ;;
        -*) echo "validation.sh: unknown option $1" >&2; exit 2 ;;
        *) cases+=("$1") ;;
    esac
    shift
done
[ ${#cases[@]} -gt 0 ] || cases=(still_tank empty_channel dam_break_2d spheric02 planing_prism)
command -v jq >/dev/null || { echo "validation.sh: jq is missing: apt-get install jq" >&2; exit 2; }
program=build/twinwake judge=build/tests/validation/sph/validation_rows data=tests/data
for file in "$program" "$judge"; do
    [ -x "$file" ] || { echo "validation.sh: $file is missing: ./bootstrap.sh build" >&2; exit 2; }
done
case $method in both) methods=(sph fvm) ;; sph | fvm) methods=("$method") ;; *) echo "validation.sh: --method $method: expected sph, fvm or both" >&2; exit 2 ;; esac

# run SCENE FOLDER [options]: every wanted method, each resumed from where it stopped; a failure is told and left behind.
run() {
    local scene=$1 folder=$2 m
    shift 2
    for m in "${methods[@]}"; do
        local command=("$program" run "studies/$scene.toml" --no-twins --method "$m" --out "$folder" "$@")
        printf '    %s\n' "${command[*]}"
        [ "$rows_only" = 0 ] || continue
        if [ -e "$folder/$m/record.h5" ] || [ -e "$folder/$m/checkpoint.h5" ]; then command+=(--resume); fi
        "${command[@]}" --quiet >&2 || echo "    (exit status $?)"
    done
}

# judged JUDGE SCENE FOLDER [measured]: rows of each method's record against exact or measured values.
judged() {
    local m
    for m in "${methods[@]}"; do
        if [ -f "$3/$m/record.h5" ]; then "$judge" "$1" "studies/$2.toml" "$3/$m/record.h5" "${@:4}" || true; fi
    done
}
judged_head() { printf '\n| case | method | quantity | deviation | limit | |\n|---|---|---|---|---|---|\n'; }

# Both methods' values of every judged quantity, and what a formula says of it.
compared() {
    local folder=$1 name=$2 records=()
    for m in "${methods[@]}"; do if [ -f "$folder/$m/record.h5" ]; then records+=("$folder/$m/record.h5"); fi; done
    [ ${#records[@]} -gt 0 ] || return 0
    "$program" compare "${records[@]}" --out "$folder" --quiet >&2 || return 0
    jq -r --arg name "$name" '
        def round3: if . == null then "-" else (. as $x | if $x == 0 then 0 else ($x | fabs | log10 | floor) as $e | ($x / pow(10; $e - 3) | round) * pow(10; $e - 3) end | tostring) end;
        . as $all | .quantities[] | select(.judged) | . as $q |
        "| \($name) | \($q.label) [\($q.unit)] | " +
        ([range($all.sources | length) | "\($all.sources[.].name) \($q.values[.] | round3) ± \($q.intervals[.] | round3)"] | join(" | ")) +
        " | \($q.per_cent | round3) % | \($q.verdict) | " +
        ([$all.references[] | select(.quantity == $q.name) | "\(.source): \(.value | round3) \(.unit)"] | join("; ")) + " |"' "$folder/report.json"
    jq -r --arg name "$name" '.cost[] | "| \($name) | cost, \(.source) | \(.elements) elements, \(.steps) steps | \(.wall | round) s | | | |"' "$folder/report.json"
}
compared_head() {
    printf '\n| case | quantity |'; for m in "${methods[@]}"; do printf ' %s |' "$m"; done
    printf ' difference | verdict | formula |\n|---|---|'; for m in "${methods[@]}"; do printf -- '---|'; done; printf -- '---|---|---|\n'
}

for case in "${cases[@]}"; do
    printf '\n## %s\n\n' "$case"
    case $case in
        still_tank)
            run still_tank "$out/still_tank"
            judged_head; judged still still_tank "$out/still_tank"; judged buoyancy still_tank "$out/still_tank" ;;
        empty_channel)
            run empty_channel "$out/empty_channel"
            judged_head; judged channel empty_channel "$out/empty_channel" ;;
        dam_break_2d)
            run dam_break_2d "$out/dam_break_2d"
            judged_head; judged front dam_break_2d "$out/dam_break_2d" "$data/dambreak_front_bem.csv"
            judged measured_front dam_break_2d "$out/dam_break_2d" "$data/dambreak_front_position.csv" ;;
        spheric02)
            run spheric02 "$out/spheric02"
            judged_head; judged spheric2 spheric02 "$out/spheric02" "$data/spheric02_kleefsman_2005_3d_dambreak.csv" ;;
        planing_prism)
            for parts in 20 28 40; do   # spacings in parts of the beam of 1 m
                run planing_prism "$out/planing_prism_$parts" --near-hull "$(awk -v n="$parts" 'BEGIN { printf "%.9f", 1 / n }')"
            done
            compared_head
            for parts in 20 28 40; do compared "$out/planing_prism_$parts" "prism, beam/$parts"; done ;;
        seaplane_*)
            [ -f "studies/$case.toml" ] || { echo "validation.sh: there is no studies/$case.toml" >&2; exit 2; }
            run "$case" "$out/$case"
            compared_head; compared "$out/$case" "$case" ;;
        *) echo "validation.sh: unknown case '$case'" >&2; exit 2 ;;
    esac
done
