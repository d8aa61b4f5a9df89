#!/usr/bin/env bash
# usage: sbom_test.sh PACKAGE_SBOM PROGRAM. The bill names what the program loads, with the versions that are installed, is
# the same twice, and is not written for what is none of Debian's.
set -uo pipefail
sbom=$1 program=$2
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
status=0
fail() { echo "sbom_test.sh: $*" >&2; status=1; }

export SOURCE_DATE_EPOCH=1700000000
"$sbom" "$program" 1.2.3 libeigen3-dev npm:three@0.187.0 >"$folder/one.json" || fail "it ends with $?"
"$sbom" "$program" 1.2.3 libeigen3-dev npm:three@0.187.0 >"$folder/two.json"
cmp "$folder/one.json" "$folder/two.json" || fail "two bills differ"
for package in libhdf5-103-1 libstdc++6 libeigen3-dev; do
    version=$(dpkg-query -W -f '${Version}' "$package" 2>/dev/null) || continue  # another release's name
    grep -qF "\"name\": \"$package\", \"versionInfo\": \"$version\"" "$folder/one.json" || fail "$package $version is not there"
done
grep -q '"created": "2023-11-14T22:13:20Z"' "$folder/one.json" || fail "the date is not SOURCE_DATE_EPOCH's"
grep -q "\"checksumValue\": \"$(sha256sum "$program" | cut -d ' ' -f 1)\"" "$folder/one.json" || fail "the checksum is not the program's"
[ "$(grep -c 'SPDXRef-libeigen3-dev' "$folder/one.json")" = 2 ] || fail "libeigen3-dev is not listed and linked once"
[ "$(grep -c 'SPDXRef-npm-three' "$folder/one.json")" = 2 ] || fail "three is not listed and contained once"
grep -q '"pkg:npm/three@0.187.0"' "$folder/one.json" || fail "three has no address of a package"
printf 'file(READ "%s" text)\nstring(JSON n LENGTH "${text}" packages)\nif(n LESS 5)\n message(FATAL_ERROR "${n} packages")\nendif()\n' \
    "$folder/one.json" >"$folder/read.cmake"
cmake -P "$folder/read.cmake" || fail "it is no JSON with packages"
"$sbom" "$folder/nothing" 1 2>/dev/null && fail "a program that is not there has a bill"
"$sbom" "$program" 1 no-such-package >/dev/null 2>&1 && fail "a package that is not installed is listed"
exit $status
