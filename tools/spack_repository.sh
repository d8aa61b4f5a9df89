#!/usr/bin/env bash
# Writes a repository for Spack with the recipe of this checkout: the archive of its last commit, and package/spack/package.py
# with that archive's place and SHA-256. The same commit gives the same archive, and so the same checksum.
#
#   tools/spack_repository.sh FOLDER      a new folder; then: spack repo add FOLDER && spack install twinwake
#
# Exit status: 0 written; 2 wrong usage, or the folder is there.
set -euo pipefail
checkout=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
die() { echo "spack_repository: $*" >&2; exit 2; }
[ $# = 1 ] && [[ $1 != -* ]] || { sed -n '2,7p' "${BASH_SOURCE[0]}" | cut -c3- >&2; exit 2; }
[ ! -e "$1" ] || die "$1 is there already; expected a new folder"
version=$(sed -n 's/^project(twinwake VERSION \([0-9.]*\).*/\1/p' "$checkout/CMakeLists.txt")
[ -n "$version" ] || die "$checkout/CMakeLists.txt names no version"
git -C "$checkout" rev-parse -q --verify HEAD >/dev/null || die "$checkout is no git checkout, of which an archive could be made"
git -C "$checkout" diff --quiet HEAD || echo "spack_repository: changes since the last commit are not in the archive" >&2
mkdir -p "$1/packages/twinwake"
folder=$(cd "$1" && pwd)
archive=$folder/twinwake-$version.tar.gz
git -C "$checkout" archive --format=tar --prefix="twinwake-$version/" HEAD | gzip -n >"$archive"
hash=$(sha256sum "$archive" | cut -d ' ' -f 1)
printf 'repo:\n  namespace: twinwake\n' >"$folder/repo.yaml"
sed -e "s|@ARCHIVE@|file://$archive|" -e "s|@VERSION@|$version|" -e "s|@SHA256@|$hash|" \
    "$checkout/package/spack/package.py" >"$folder/packages/twinwake/package.py"
echo "$archive: SHA-256 $hash"
echo "next: spack repo add $folder && spack install twinwake"
