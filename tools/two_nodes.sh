#!/usr/bin/env bash
# Runs a command on ranks of two nodes that are not there: two network namespaces of this machine, joined by a cable of
# their own, each with a name and a folder for temporary files. The ranks of one reach those of the other by TCP alone.
#
#   tools/two_nodes.sh RANKS_EACH COMMAND...
#   tools/two_nodes.sh 2 build/twinwake run my.toml --method sph --no-twins
#
# Needs mpirun (OpenMPI), unshare and nsenter (util-linux), ip (iproute2), and to be root, or a kernel that lets users
# make namespaces. Exit status 77, with the reason: that cannot be had here; else that of mpirun.
set -euo pipefail
(($# >= 2)) || { sed -n '2,10s/^# \{0,1\}//p' "$0"; exit 2; }

if [[ ${TWO_NODES_INSIDE-} != 1 ]]; then
    for tool in mpirun unshare nsenter ip; do
        command -v $tool > /dev/null || { echo "two_nodes.sh: there is no $tool here"; exit 77; }
    done
    as_root=--map-root-user
    ((EUID == 0)) && as_root=
    unshare $as_root --net --uts true 2> /dev/null ||
        { echo "two_nodes.sh: no network namespace can be made here: not root, and users may not"; exit 77; }
    TWO_NODES_INSIDE=1 exec unshare $as_root --net --uts --kill-child --fork "$0" "$@"
fi

each=$1
shift
files=$(mktemp -d)
unshare --net --uts --kill-child sleep infinity &
other=$!
trap 'kill $other 2> /dev/null; rm -rf "$files"' EXIT
until [[ $(readlink /proc/$other/ns/net) != $(readlink /proc/$$/ns/net) ]]; do sleep 0.01; done

hostname node1
nsenter --target $other --uts hostname node2
ip link add cable1 type veth peer name cable2 netns $other 2> "$files/why" ||
    { echo "two_nodes.sh: no cable between two namespaces: $(cat "$files/why")"; exit 77; }
ip address add 10.77.0.1/24 dev cable1
ip link set cable1 up
ip link set lo up
nsenter --target $other --net sh -c \
    'ip address add 10.77.0.2/24 dev cable2; ip link set cable2 up; ip link set lo up'

# in place of ssh: its first word is the node
mkdir "$files/node1" "$files/node2"
cat > "$files/agent" << END
#!/bin/sh
shift
TMPDIR=$files/node2 exec nsenter --target $other --net --uts sh -c "\$*"
END
chmod +x "$files/agent"
export TMPDIR=$files/node1 OMPI_MCA_plm_rsh_agent=$files/agent OMPI_MCA_btl=tcp,self
export OMPI_MCA_btl_tcp_if_include=10.77.0.0/24 OMPI_MCA_oob_tcp_if_include=10.77.0.0/24
export OMPI_MCA_mpi_yield_when_idle=1 OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
mpirun --host 10.77.0.1:$each,10.77.0.2:$each -n $((2 * each)) --bind-to none --quiet "$@"
