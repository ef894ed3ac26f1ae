#!/usr/bin/env bash
# bench/class_at_the_door.ts with the browser in a network of its own, as a computer beside the server has it: a second
# network namespace with one cable to this one, where the door listens. Beside the class a stranger on that network
# tries every TCP port of this machine, and asks by DDS for the class's server: FOLDER/stranger.txt.
#
# usage: build/release/bin/own_domain bench/class_from_outside.sh FOLDER [HANDS [TIME_SCALE]]   (as root; after a build)
set -euo pipefail
cd "$(dirname "$0")/.."

outside=windlass-outside
here=10.212.8.1
there=10.212.8.2
folder=${1:?usage: bench/class_from_outside.sh FOLDER [HANDS [TIME_SCALE]]}
mkdir -p "$folder"
cleanup() {
    [[ -z ${stranger-} ]] || kill "$stranger" 2>/dev/null || true
    ip netns pids "$outside" 2>/dev/null | xargs -r kill 2>/dev/null || true
    ip netns del "$outside" 2>/dev/null || true
    ip link del windlass-here 2>/dev/null || true
    [[ -z ${tmp-} ]] || rm -rf "$tmp"
}
trap cleanup EXIT
cleanup
tmp=$(mktemp -d)
ip netns add "$outside"
ip link add windlass-here type veth peer name windlass-there netns "$outside"
ip addr add "$here/24" dev windlass-here
ip link set windlass-here up
ip -n "$outside" addr add "$there/24" dev windlass-there
ip -n "$outside" link set windlass-there up
ip -n "$outside" link set lo up

stranger() {
    until [[ $(ss -Hltn "src $here") ]]; do sleep 1; done
    echo "TCP ports of $here that answer:"
    ip netns exec "$outside" node --eval '
        const net = require("node:net");
        const answers = (port) => new Promise((told) => {
            const socket = net.connect({ host: process.argv[1], port, timeout: 2000 });
            const end = (open) => { socket.destroy(); told(open); };
            socket.on("connect", () => end(true)).on("error", () => end(false)).on("timeout", () => end(false));
        });
        (async () => {
            for (let first = 1; first < 65536; first += 256) {
                const ports = Array.from({ length: 256 }, (_, i) => first + i).filter((port) => port < 65536);
                const open = await Promise.all(ports.map(answers));
                ports.filter((_, i) => open[i]).forEach((port) => console.log(port));
            }
        })();' "$here"
    local console=(build/release/bin/instructor_console --domain "$WINDLASS_DOMAIN" --partition nine-oclock)
    echo "The class's server by DDS, on this machine:"
    "${console[@]}" status 2>&1 | head -3 || true
    echo "and from the other network:"
    ip netns exec "$outside" "${console[@]}" --lan status 2>&1 | head -3 || true
}
stranger >"$folder/stranger.txt" 2>&1 &
stranger=$!

# What Playwright starts as Chromium.
printf '#!/bin/sh\nexec ip netns exec %s /usr/bin/chromium "$@"\n' "$outside" >"$tmp/chromium"
chmod +x "$tmp/chromium"
WINDLASS_CHROMIUM=$tmp/chromium WINDLASS_DOOR_ADDRESS=$here \
    node station/web/tools/ts.mjs bench/class_at_the_door.ts "$@"
