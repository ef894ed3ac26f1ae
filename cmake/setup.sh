# Sourced by ./run and ./check: installs what packages.txt lists and builds a preset. Needs Debian 12 and bash.

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

say() { printf '== %s\n' "$*" >&2; }
fail() {
    printf '%s: %s\n' "$(basename "$0")" "$*" >&2
    exit 1
}

missing_packages() {
    local package command
    sed 's/#.*//' "$root/packages.txt" | while read -r package command; do
        [[ -n $command ]] && command -v "$command" >/dev/null && continue
        [[ -z $package || $(dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null) == installed ]] ||
            echo "$package"
    done
}

# Installs what is missing, as root or through sudo, asking nothing; a password only where there is a terminal.
install_packages() {
    local missing as_root=()
    command -v dpkg-query >/dev/null || fail "this needs Debian 12 (there is no dpkg-query here)"
    mapfile -t missing < <(missing_packages)
    ((${#missing[@]})) || return 0
    say "installing ${#missing[@]} Debian packages: ${missing[*]}"
    if ((EUID != 0)); then
        command -v sudo >/dev/null || fail "packages are missing and there is no sudo; as root, run:
    apt-get install --no-install-recommends ${missing[*]}"
        as_root=(sudo)
        [[ -t 0 ]] || as_root=(sudo -n)
        "${as_root[@]}" true || fail "sudo is refused; as root, run:
    apt-get install --no-install-recommends ${missing[*]}"
    fi
    local apt=("${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -qq -o Dpkg::Use-Pty=0)
    "${apt[@]}" update >/dev/null || say "the package lists could not all be updated; going on with what is there"
    "${apt[@]}" install -y --no-install-recommends "${missing[@]}" >/dev/null || fail "apt-get could not install \
the packages (its message is above). Is this Debian 12, and is the package archive within reach?"
}

# build PRESET [TARGET...]: programs land in build/PRESET/bin. Quiet when there is nothing to do.
build() {
    local preset=$1
    shift
    local log="$root/build/$preset.log"
    mkdir -p "$root/build"
    say "building $preset"
    (cd "$root" && cmake --preset "$preset") >"$log" 2>&1 || {
        cat "$log" >&2
        fail "configuring $preset failed"
    }
    cmake --build "$root/build/$preset" -j "$(nproc)" ${1:+--target "$@"} >&2 || fail "building $preset failed"
}
