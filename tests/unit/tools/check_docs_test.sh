#!/usr/bin/env bash
# tools/check_docs.sh (its path is the argument) passes a sound folder and names every fault put into it.
set -uo pipefail
check=$1
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
mkdir -p "$folder/docs" "$folder/scene/keys"
cat >"$folder/program" <<'END'
#!/usr/bin/env bash
case $1 in
    --help) printf '  run    runs a scene\n' ;;
    run) printf '  --out FOLDER   where to\n' ;;
esac
END
chmod +x "$folder/program"
echo '// see docs/theory.md' >"$folder/scene/keys/keys.cpp"
printf '# Theory\n\n## A wave, and `more`\n' >"$folder/docs/theory.md"
sound='[all](docs/theory.md), [part](docs/theory.md#a-wave-and-more), `scene/keys/keys.cpp`, `keys.cpp`, `twinwake run my.toml --out x`.'

wrong=0
# expect LINE OUTPUT: a page with this line makes the check say this; without output, nothing.
expect() {
    printf '# Page\n\n%s\n\n%s\n' "$sound" "$1" >"$folder/README.md"
    local said status
    said=$("$check" --program "$folder/program" "$folder")
    status=$?
    if [ "$said" != "$2" ] || [ "$status" != $([ -z "$2" ]; echo $?) ]; then
        printf 'for: %s\nexpected: %s\nfound (%d): %s\n' "$1" "$2" "$status" "$said"
        wrong=1
    fi
}
expect '' ''
expect '[gone](docs/gone.md)' 'README.md: dead link (docs/gone.md)'
expect '[gone](docs/theory.md#no-wave)' 'README.md: no such heading (docs/theory.md#no-wave)'
expect '`scene/gone.cpp`' 'README.md: no such file (scene/gone.cpp)'
expect '`gone.h`' 'README.md: no such file (gone.h)'
expect '`twinwake walk my.toml`' 'README.md: twinwake has no command walk'
expect '`twinwake run my.toml --speed 3`' 'README.md: twinwake run has no option --speed'
mkdir -p "$folder/tests"
printf 'TEST(Waves, Decay) {}\nTEST_F(Waves, Break) {}\n' >"$folder/tests/waves_test.cpp"
printf '| a wave | `Waves.Decay`, `Waves.Break` |\n' >"$folder/docs/audit.md"
expect '' ''
printf '| a wave | `Waves.Grow` |\n' >"$folder/docs/audit.md"
expect '' 'docs/audit.md: no such test (Waves.Grow)'
rm "$folder/docs/audit.md"
echo '// see docs/gone.md' >"$folder/scene/keys/keys.cpp"
expect '' 'scene/keys/keys.cpp:1: no such file (docs/gone.md)'
exit $wrong
