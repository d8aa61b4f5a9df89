#!/usr/bin/env bash
# Installs a build into a folder of its own and looks at it as a user who has no checkout: the links of its pages lead to
# pages, what its messages name is there, and setting up the second method fails with the reason and leaves nothing.
#
#   tests/robustness/package/installed_test.sh BUILD CHECKOUT
#
# Exit status: 0 all is so, 1 something is not (one line each).
set -uo pipefail
build=$1 checkout=$2
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
failed=0
tell() { printf 'FAILED: %s\n' "$1"; failed=1; }
expect() {  # $1: what is expected, $2: a part of the text on standard input
    local text
    text=$(cat)
    [[ $text == *"$2"* ]] || tell "$1: expected '$2' in: $text"
}

cmake --install "$build" --prefix "$folder/usr" >"$folder/log" 2>&1 || { cat "$folder/log"; tell "cmake --install"; exit 1; }
pages=$folder/usr/share/doc/twinwake
[ "$(find "$pages" -name '*.md' | wc -l)" -gt 100 ] || tell "the manual's pages are not in $pages"
"$checkout/tools/check_docs.sh" --links "$pages" || tell "pages of the installation have dead links"
for file in LICENSE docs/images/planing_prism_sph.png docs/examples/first_run.ipynb; do
    [ -s "$pages/$file" ] || tell "no $file in $pages"
done

# Without any OpenFOAM, a home that is empty and a search path that has no compiler.
mkdir -p "$folder/home" "$folder/bin"
for tool in bash sed cat mkdir realpath dirname sha256sum cut awk df id rm head tr; do
    ln -s "$(command -v "$tool")" "$folder/bin/$tool"
done
installed() {  # a command of the installed program where nothing else is
    env -i HOME="$folder/home" PATH="$folder/bin" TWINWAKE_OPENFOAM_PLACES=/nowhere XDG_CACHE_HOME="$folder/cache" \
        "$folder/usr/bin/twinwake" "$@" 2>&1
}
demo=(run "$folder/usr/share/twinwake/studies/demo.toml" --method fvm --out "$folder/none")
installed "${demo[@]}" | expect "a run names the command of this installation" "$folder/usr/bin/twinwake setup-openfoam"
ln -s "$folder/usr/bin/twinwake" "$folder/bin/twinwake"
said=$(installed doctor)
expect "doctor names the command as it is called" $'\n  twinwake setup-openfoam\n' <<<"$said"
[[ $said != *bootstrap* ]] || tell "doctor names bootstrap.sh, which is not installed: $said"

installed setup-openfoam | expect "a system without apt" "this system has no apt"
printf '#!/bin/bash\nexit 1\n' >"$folder/bin/dpkg-query"
cp "$folder/bin/dpkg-query" "$folder/bin/apt-get"
chmod +x "$folder/bin/dpkg-query" "$folder/bin/apt-get"
installed setup-openfoam | expect "the package is missing" "apt-get install --no-install-recommends openfoam dpkg-dev"
printf '#!/bin/bash\necho installed 1912.200626-1\n' >"$folder/bin/dpkg-query"
installed setup-openfoam | expect "a compiler is missing" "'dpkg-source' is missing: sudo apt-get install"
installed setup-openfoam >/dev/null
[ $? = 2 ] || tell "setup-openfoam without a compiler: expected exit status 2"
[ -z "$(ls -A "$folder/home")" ] || tell "setup-openfoam left something: $(find "$folder/home")"
mv "$folder/usr/share/twinwake/tools" "$folder/elsewhere"
installed setup-openfoam | expect "its script is missing" "install twinwake whole"
exit $failed
