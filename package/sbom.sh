#!/usr/bin/env bash
# Writes the bill of materials of a built twinwake as SPDX 2.3 (JSON): the program with its SHA-256, the Debian packages
# whose libraries it or its own libraries load, and those whose headers are compiled into it, each with version and source
# package, and the npm packages whose scripts it writes into its reports. The same program on the same packages gives the same
# bytes when SOURCE_DATE_EPOCH says the date.
#
#   package/sbom.sh PROGRAM VERSION [HEADER_PACKAGE | npm:NAME@VERSION ...] > twinwake.spdx.json
#
# Libraries that no Debian package brought are left out. Exit status: 0 written, 1 none of its libraries, or not a
# header package, is an installed Debian package, 2 wrong usage.
set -euo pipefail
export LC_ALL=C
[ $# -ge 2 ] && [ -f "$1" ] || { sed -n '2,10p' "${BASH_SOURCE[0]}" | cut -c3- >&2; exit 2; }
program=$1 version=$2
shift 2
die() { echo "sbom.sh: $*" >&2; exit 1; }

# The packages that brought these files, one a line; /lib is /usr/lib, and packages know a file by either name.
packages_of() {
    { dpkg-query -S "$@" "${@#/usr}" 2>/dev/null || true; } | sed 's/: .*//' | sort -u
}
shopt -s nullglob
own=("$(dirname "$program")"/../lib/twinwake/*.so)  # loaded where it is needed
mapfile -t files < <(ldd "$program" "${own[@]}" | sed -n 's/.*=> \(\/[^ ]*\) .*/\1/p; s/^[[:space:]]*\(\/[^ ]*\) (.*/\1/p' | xargs -r realpath)
[ ${#files[@]} -gt 0 ] || die "$program loads no library"
mapfile -t loaded < <(packages_of "${files[@]}")
[ ${#loaded[@]} -gt 0 ] || die "no library that $program loads is of a Debian package"
headers=() scripts=()
for part; do
    if [[ $part =~ ^npm:([a-z-]+)@([0-9.]+)$ ]]; then scripts+=("${BASH_REMATCH[1]} ${BASH_REMATCH[2]}"); else headers+=("$part"); fi
done

# entries PACKAGE...: their entries in the list of packages. Identifiers allow no plus, and in a URL it means a blank.
entries() {
    dpkg-query -W -f '${Package}\t${Version}\t${source:Package} ${source:Version}\n' "$@" | while IFS=$'\t' read -r name at source; do
        local url=${at//+/%2B}
        printf ',\n    {"SPDXID": "SPDXRef-%s", "name": "%s", "versionInfo": "%s",\n' "${name//+/-plus}" "$name" "$at"
        printf '     "sourceInfo": "Debian source package %s", "downloadLocation": "NOASSERTION", "filesAnalyzed": false,\n' "$source"
        printf '     "externalRefs": [{"referenceCategory": "PACKAGE-MANAGER", "referenceType": "purl",\n'
        printf '                       "referenceLocator": "pkg:deb/debian/%s@%s"}]}' "${name//+/%2B}" "${url//:/%3A}"
    done
}
# The same of npm's packages, each NAME VERSION.
script_entries() {
    local name at
    for part; do
        read -r name at <<<"$part"
        printf ',\n    {"SPDXID": "SPDXRef-npm-%s", "name": "%s", "versionInfo": "%s",\n' "$name" "$name" "$at"
        printf '     "licenseConcluded": "MIT", "downloadLocation": "NOASSERTION", "filesAnalyzed": false,\n'
        printf '     "externalRefs": [{"referenceCategory": "PACKAGE-MANAGER", "referenceType": "purl",\n'
        printf '                       "referenceLocator": "pkg:npm/%s@%s"}]}' "$name" "$at"
    done
}
# relations KIND PACKAGE...
relations() {
    local kind=$1
    shift
    for package; do
        package=${package%%:*}
        printf ',\n    {"spdxElementId": "SPDXRef-program", "relationshipType": "%s", "relatedSpdxElement": "SPDXRef-%s"}' \
            "$kind" "${package//+/-plus}"
    done
}

hash=$(sha256sum "$program" | cut -d ' ' -f 1)
list=$(entries "${loaded[@]}" "${headers[@]}" && script_entries "${scripts[@]}")
printf '{\n  "spdxVersion": "SPDX-2.3", "dataLicense": "CC0-1.0", "SPDXID": "SPDXRef-DOCUMENT",\n'
printf '  "name": "twinwake-%s", "documentNamespace": "urn:sha256:%s",\n' "$version" "$hash"
printf '  "creationInfo": {"created": "%s", "creators": ["Organization: twinwake developers"]},\n' \
    "$(date -u -d "@${SOURCE_DATE_EPOCH:-$(date +%s)}" +%Y-%m-%dT%H:%M:%SZ)"
printf '  "packages": [\n    {"SPDXID": "SPDXRef-program", "name": "twinwake", "versionInfo": "%s",\n' "$version"
printf '     "downloadLocation": "NOASSERTION", "filesAnalyzed": false,\n'
printf '     "checksums": [{"algorithm": "SHA256", "checksumValue": "%s"}]}%s\n  ],\n' "$hash" "$list"
printf '  "relationships": [\n'
printf '    {"spdxElementId": "SPDXRef-DOCUMENT", "relationshipType": "DESCRIBES", "relatedSpdxElement": "SPDXRef-program"}'
relations DYNAMIC_LINK "${loaded[@]}"
relations STATIC_LINK "${headers[@]}"
for part in "${scripts[@]}"; do relations CONTAINS "npm-${part%% *}"; done
printf '\n  ]\n}\n'
