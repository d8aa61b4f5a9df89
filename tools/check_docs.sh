#!/usr/bin/env bash
# Finds what the documentation names and what does not exist.
#
#   tools/check_docs.sh [--program build/twinwake | --links] [FOLDER]        FOLDER: the checkout (default: this one)
#
# In every .md file: relative links and their anchors, and files named in `code`: with a folder (`scene/keys/keys.cpp`) they
# stand there or below the page's own folder, without (`keys.cpp`) anywhere. Capitals and stars mark a placeholder. In
# sources: paths of headers and pages named in comments. In docs/audit.md: the tests named there. With --program also the
# commands of the pages: subcommands and long options of `twinwake ...` in its own --help. Pages of docs/decisions and
# CHANGELOG.md tell what was, so files and commands named there may have gone; their links may not. With --links nothing
# but links: of pages that have been installed, without the sources that they name.
# Exit status: 0 nothing found, 1 something found (one line each), 2 wrong usage.
set -uo pipefail
program="" links_only=0
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
while [ $# -gt 0 ]; do
    case $1 in
        --program) program=$(realpath -- "${2:?--program needs a file}"); shift ;;
        --links) links_only=1 ;;
        -*) echo "check_docs.sh: unknown option $1" >&2; exit 2 ;;
        *) root=$1 ;;
    esac
    shift
done
cd "$root" || exit 2

declare -A exists=() named=()   # every file and folder of the tree; every last part of a path
while IFS= read -r path; do
    exists[$path]=1 named[${path##*/}]=1
    while [[ $path == */* ]]; do path=${path%/*}; exists[$path]=1 named[${path##*/}]=1; done
done < <(git ls-files --cached --others --exclude-standard 2>/dev/null ||
         find . -type f -not -path '*/.*' -not -path './build*' | sed 's|^\./||')
mapfile -t pages < <(printf '%s\n' "${!exists[@]}" | grep '\.md$' | sort)
[ ${#pages[@]} -gt 0 ] || { echo "check_docs.sh: no pages in $root" >&2; exit 2; }

found=0
tell() { printf '%s\n' "$1"; found=1; }
clean_path() {   # a/../b -> b, without asking the disk
    local part out=()
    local IFS=/
    for part in $1; do
        case $part in
            '' | .) ;;
            ..) [ ${#out[@]} -gt 0 ] && unset 'out[-1]' ;;
            *) out+=("$part") ;;
        esac
    done
    printf '%s' "${out[*]}"
}
without_blocks() { awk '/^ *```/ { inside = !inside; print ""; next } { print inside ? "" : $0 }' "$1"; }
anchors() {      # of a page's headings, as they are made from them: lower case, no punctuation, - for a space
    without_blocks "$1" | sed -n 's/^#\+ //p' | sed 's/[`*]//g; s/\[\([^]]*\)\]([^)]*)/\1/g' |
        awk '{ s = tolower($0); gsub(/[^a-z0-9 _-]/, "", s); gsub(/ /, "-", s); print s }'
}

# --- links
for page in "${pages[@]}"; do
    folder=""
    [[ $page == */* ]] && folder=${page%/*}
    while IFS= read -r link; do
        case $link in http://* | https://* | mailto:*) continue ;; esac
        file=${link%%#*} target=$page
        [ -z "$file" ] || target=$(clean_path "$folder/$file")
        if [ -n "$target" ] && [ -z "${exists[$target]:-}" ]; then
            tell "$page: dead link ($link)"
        elif [[ $link == *#* && $target == *.md ]] && ! anchors "$target" | grep -qxF -- "${link#*#}"; then
            tell "$page: no such heading ($link)"
        fi
    done < <(without_blocks "$page" | tr '\n' ' ' | grep -oE '\]\([^) ]+\)' | sed 's/^](//; s/)$//')
done

[ $links_only = 0 ] || exit $found

# --- files named in pages
for page in "${pages[@]}"; do
    case $page in docs/decisions/[0-9]* | CHANGELOG.md) continue ;; esac
    folder=""
    [[ $page == */* ]] && folder=${page%/*}
    while IFS= read -r name; do
        name=${name%/}
        [ -n "${exists[$name]:-}${exists[$folder/$name]:-}" ] && continue
        [[ $name != */* && -n "${named[$name]:-}" ]] && continue
        tell "$page: no such file ($name)"
    done < <(without_blocks "$page" | grep -oE '`[^` ]+`' | tr -d '`' |
             grep -E '^[a-z0-9_./-]+\.(h|cpp|sh)$|^[a-z0-9_./-]+/[a-z0-9_.-]+\.(md|txt|js|in|csv|bash|toml|stl)$|^[a-z_0-9/]+/$' |
             sed 's|^\./||' | grep -vE '^(runs|build[a-z-]*|case|constant|system)/|(^|/)my_')
done

# --- tests named in the table of what can go wrong
if [ -n "${exists[docs/audit.md]:-}" ]; then
    declare -A tests=()
    while IFS= read -r name; do tests[$name]=1; done < <(
        printf '%s\n' "${!exists[@]}" | grep -E '^tests/.*\.cpp$' | xargs -r grep -hoE \
            '^TEST(_[FP])?\([A-Za-z0-9]+, *[A-Za-z0-9]+\)' | sed -E 's/^TEST[_FP]*\((.*), *(.*)\)$/\1.\2/')
    while IFS= read -r name; do
        [ -n "${tests[$name]:-}" ] || tell "docs/audit.md: no such test ($name)"
    done < <(grep -oE '`[A-Z][A-Za-z0-9]*\.[A-Z][A-Za-z0-9]*`' docs/audit.md | tr -d '`' | sort -u)
fi

# --- paths named in comments of sources
rooms=$(printf '%s\n' "${!exists[@]}" | sed -n 's|/.*||p' | sort -u | grep -E '^[a-z_]+$' | paste -sd '|')
while IFS=: read -r source line path; do
    [ -n "${exists[$path]:-}" ] || compgen -G "$path*" >/dev/null || tell "$source:$line: no such file ($path)"
done < <(printf '%s\n' "${!exists[@]}" | grep -E '\.(h|cpp|sh|txt|in)$' | grep -v '_test\.sh$' | sort | xargs grep -HnoE \
    "(^|[ (])($rooms)/[a-z0-9_/]+(\.(h|cpp|sh|md)|/[0-9]{3})([^a-z0-9]|\$)" |
    sed 's/:\([0-9]*\):[ (]/:\1:/; s/[^a-z0-9]$//')

# --- commands
if [ -n "$program" ]; then
    declare -A help=()
    overview=$("$program" --help)
    while IFS= read -r command; do
        read -r -a words <<<"$command"
        page=${words[0]} sub=${words[2]:-}
        [[ $sub =~ ^[a-z]+(-[a-z]+)*$ ]] || sub=""
        if [ -n "$sub" ] && ! grep -qE "^ +$sub( |$)" <<<"$overview"; then
            tell "$page: twinwake has no command $sub"
            continue
        fi
        [ -n "${help[${sub:--}]:-}" ] || help[${sub:--}]=$([ -z "$sub" ] && echo "$overview" || "$program" "$sub" --help)
        key=${sub:--} below=${words[3]:-}
        if [[ -n $sub && $below =~ ^[a-z]+$ ]] && grep -qE "^ +$below( |$)" <<<"${help[$sub]}"; then
            key="$sub $below"
            [ -n "${help[$key]:-}" ] || help[$key]=$("$program" "$sub" "$below" --help)
        fi
        for word in "${words[@]:2}"; do
            [[ $word =~ ^(--[a-z0-9-]+) ]] || continue
            grep -qE -- "${BASH_REMATCH[1]}([^a-z0-9-]|$)" <<<"${help[$key]}" ||
                tell "$page: twinwake $sub has no option ${BASH_REMATCH[1]}"
        done
    done < <(for page in "${pages[@]}"; do
                 case $page in docs/decisions/[0-9]* | CHANGELOG.md) continue ;; esac
                 # Lines of code blocks that end in a backslash go on; a comment, a pipe or a second command ends them.
                 { awk '/^ *```/ { inside = !inside; next } inside' "$page" | sed ':a; /\\$/ { N; s/\\\n//; ba }'
                   without_blocks "$page" | tr '\n' ' ' | grep -oE '`[^`]+`' | tr -d '`'; } |
                     sed -nE 's@^ *(.*/)?twinwake( [^#|;&]*).*@'"$page"' twinwake\2@p'
             done)
fi
exit $found
