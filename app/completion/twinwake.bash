# Completion of the twinwake command for bash:  source app/completion/twinwake.bash
# Names of effects and shapes come from the program itself, so that there is one list of them.
_twinwake_names() { "${COMP_WORDS[0]}" reference --names "$1" 2>/dev/null | tr '\n' ' '; }
_twinwake() {
    local word=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD - 1]} command=${COMP_WORDS[1]}
    local scene="--hull --speed --trim --near-hull --spacing --scale --duration --effect"
    local words=""
    COMPREPLY=()
    if [ "$COMP_CWORD" -eq 1 ]; then
        COMPREPLY=($(compgen -W "new check reference run compare ladder sweep ablate import uncertainty hull case doctor stability spray bench --help --version" -- "$word"))
        return
    fi
    case $previous in
        --method) COMPREPLY=($(compgen -W "sph fvm both" -- "$word")); return ;;
        --twins) COMPREPLY=($(compgen -W "first all none" -- "$word")); return ;;
        --require) COMPREPLY=($(compgen -W "agree" -- "$word")); return ;;
        --effects) COMPREPLY=($(compgen -W "$(_twinwake_names effects)" -- "$word")); return ;;
        --effect) COMPREPLY=($(compgen -W "$(printf '%s=on ' $(_twinwake_names effects); printf '%s=off ' $(_twinwake_names effects))" -- "$word")); return ;;
        --names) COMPREPLY=($(compgen -W "effects shapes" -- "$word")); return ;;
        --unit) COMPREPLY=($(compgen -W "m mm cm ft in" -- "$word")); return ;;
        --hull | --hulls | --measured | --json | --out | --picture | -o | --openfoam) COMPREPLY=($(compgen -f -- "$word")); return ;;
    esac
    case $command in
        new) words="--overwrite --quiet --help"
             [ "$COMP_CWORD" -eq 2 ] && words="planing seaplane tank own" ;;
        check) words="$scene --threads --picture --json --quiet --help" ;;
        reference) words="--out --names --quiet --help" ;;
        run) words="$scene --method --out --resume --overwrite --no-twins --require --threads --json --quiet --help" ;;
        compare) words="--out --ladder --measured --force --require --json --quiet --help" ;;
        ladder) words="$scene --method --levels --ratio --no-variations --no-fill --plan --measured --budget --overwrite --out --threads --json --quiet --help" ;;
        sweep) words="--hulls --speeds --trims --near-hull --scale --duration --effect --twins --overwrite --out --threads --json --quiet --help" ;;
        ablate) words="$scene --effects --method --overwrite --out --threads --json --quiet --help" ;;
        import) words="--out --overwrite --json --quiet --help" ;;
        uncertainty) words="--order --json --quiet --help" ;;
        hull) words="--unit --axes --particle-spacing --out --json --quiet --help"
              [ "$COMP_CWORD" -eq 2 ] && words="info repair make convert"
              [ "$COMP_CWORD" -eq 3 ] && [ "${COMP_WORDS[2]}" = make ] && words=$(_twinwake_names shapes) ;;
        case) words="$scene --quiet --help" ;;
        doctor) words="--openfoam --json --quiet --help" ;;
        stability) words="--quick --out --threads --json --quiet --help" ;;
        spray) words="--out --openfoam-cloud --json --quiet --help" ;;
        bench) words="--particles --h-over-dp --threads --seconds --json --quiet --help" ;;
    esac
    local IFS=$'\n'
    COMPREPLY=($(IFS=' ' compgen -W "$words" -- "$word"))
    # Where no fixed word is expected, a file may stand.
    [[ $words == *--* ]] && COMPREPLY+=($(compgen -f -- "$word"))
}
complete -o filenames -F _twinwake twinwake
