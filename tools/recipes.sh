#!/usr/bin/env bash
# Writes the recipes of this checkout for Spack and EasyBuild: the archive of its last commit, and package/spack/package.py
# and package/easybuild/twinwake.eb with that archive's place and SHA-256. The same commit gives the same archive, and so
# the same checksum.
#
#   tools/recipes.sh FOLDER      a new folder; then: spack repo add FOLDER/spack && spack install twinwake
#                                or: eb FOLDER/easybuild/twinwake-VERSION-foss-2024a.eb --robot
#
# Exit status: 0 written; 2 wrong usage, or the folder is there.
set -euo pipefail
checkout=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
die() { echo "recipes: $*" >&2; exit 2; }
[ $# = 1 ] && [[ $1 != -* ]] || { sed -n '2,9p' "${BASH_SOURCE[0]}" | cut -c3- >&2; exit 2; }
[ ! -e "$1" ] || die "$1 is there already; expected a new folder"
version=$(sed -n 's/^project(twinwake VERSION \([0-9.]*\).*/\1/p' "$checkout/CMakeLists.txt")
[ -n "$version" ] || die "$checkout/CMakeLists.txt names no version"
git -C "$checkout" rev-parse -q --verify HEAD >/dev/null || die "$checkout is no git checkout, of which an archive could be made"
git -C "$checkout" diff --quiet HEAD || echo "recipes: changes since the last commit are not in the archive" >&2
mkdir -p "$1/spack/packages/twinwake" "$1/easybuild"
folder=$(cd "$1" && pwd)
archive=twinwake-$version.tar.gz
git -C "$checkout" archive --format=tar --prefix="twinwake-$version/" HEAD | gzip -n >"$folder/$archive"
hash=$(sha256sum "$folder/$archive" | cut -d ' ' -f 1)
written() { sed -e "s|@FOLDER@|$folder|" -e "s|@ARCHIVE@|$archive|" -e "s|@VERSION@|$version|" -e "s|@SHA256@|$hash|" "$checkout/package/$1" >"$folder/$2"; }
printf 'repo:\n  namespace: twinwake\n' >"$folder/spack/repo.yaml"
written spack/package.py spack/packages/twinwake/package.py
easyconfig=easybuild/twinwake-$version-$(sed -n "s/^toolchain = .*'name': '\(.*\)', 'version': '\(.*\)'.*/\1-\2/p" "$checkout/package/easybuild/twinwake.eb").eb
written easybuild/twinwake.eb "$easyconfig"
echo "$folder/$archive: SHA-256 $hash"
echo "next: spack repo add $folder/spack && spack install twinwake"
echo "or:   eb $folder/$easyconfig --robot"
