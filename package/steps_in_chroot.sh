#!/usr/bin/env bash
# Runs the steps of package/Containerfile without podman or docker: each stage's RUN lines in a bare Debian 12 below a
# folder in place of an image. A folder that is not there is made by debootstrap; one that is has to be a Debian. As root.
#
#   package/steps_in_chroot.sh /srv/bookworm [--package build/twinwake_0.1.0_amd64.deb] [--stage installed | test]
#
# With --package the stage that builds is left out and this package is installed. --stage is the last one to be run (test).
# FROM, ENV, WORKDIR, COPY of the checkout or of the package, and RUN are understood. Exit status: that of the step which
# failed; 2: wrong usage.
set -euo pipefail
checkout=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
die() { echo "steps_in_chroot: $*" >&2; exit 2; }
root="" deb="" last=test
while [ $# -gt 0 ]; do
    case $1 in
        --package) deb=$(realpath -- "${2:?--package needs a file}"); shift ;;
        --stage) last=${2:?--stage needs a name}; shift ;;
        -*) die "unknown option $1" ;;
        *) root=$(realpath -- "$1") ;;
    esac
    shift
done
[ "$(id -u)" = 0 ] || die "chroot needs root"
if [ -n "$root" ] && [ ! -e "$root" ]; then
    echo "== a bare Debian 12 in $root"
    debootstrap --variant=minbase bookworm "$root" http://deb.debian.org/debian
fi
[ -n "$root" ] && [ -x "$root/usr/bin/apt-get" ] || die "expected the folder of a Debian, found '${root:-nothing}'"

mounted=()
leave() { local place; for place in "${mounted[@]}"; do umount -R "$place" || umount -l "$place"; done; }
trap leave EXIT
for place in proc dev sys; do
    mount --rbind "/$place" "$root/$place"
    mount --make-rslave "$root/$place"
    mounted=("$root/$place" "${mounted[@]}")
done
cp /etc/resolv.conf "$root/etc/resolv.conf"
for f in /etc/apt/apt.conf.d/*proxy*; do if [ -e "$f" ]; then cp "$f" "$root/etc/apt/apt.conf.d/"; fi; done

stage="" folder=/ environment=(HOME=/root PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin)
step() {  # one instruction with its words
    local word=$1 rest=$2
    case $word in
        FROM)
            stage=${rest##* } folder=/
            echo "== stage $stage" ;;
        ENV) environment+=("$rest") ;;
        WORKDIR) folder=$rest; mkdir -p "$root$folder" ;;
        COPY)
            if [[ $rest == --from=build* ]]; then
                if [ -n "$deb" ]; then cp "$deb" "$root/tmp/"; else cp "$root"/src/build/twinwake_*.deb "$root/tmp/"; fi
            else
                git -C "$checkout" archive HEAD | tar x -C "$root$folder"
            fi ;;
        RUN)
            echo "-- $rest"
            local from=$SECONDS
            env -i "${environment[@]}" chroot "$root" sh -ec "cd '$folder' && $rest" </dev/null
            echo "-- done in $((SECONDS - from)) s" ;;
    esac
}
text=""
while IFS= read -r line; do
    [[ $line == \#* || -z $line ]] && continue
    text+=${line%\\}
    [[ $line == *\\ ]] && continue
    word=${text%% *}
    if [ "$word" = FROM ] && [ "$stage" = "$last" ]; then break; fi
    rest=${text#* } text=""
    if [ "$word" != FROM ] && [ "$stage" = build ] && [ -n "$deb" ]; then continue; fi
    step "$word" "$rest"
done <"$checkout/package/Containerfile"
echo "all steps up to stage $last are done"
