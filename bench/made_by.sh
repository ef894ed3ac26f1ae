# shellcheck shell=bash
# What is written above the data of charts: date, machine, compiler and flags, commit. Sourced.

# made_by FILE: with the flags that the source file FILE was compiled with.
made_by() {
    local cpu compiler flags commit
    cpu=$(sed -n 's/^model name[^:]*: //p' /proc/cpuinfo | head -n 1)
    compiler=$(sed -n 's/^CMAKE_CXX_COMPILER:[^=]*=//p' "$root/build/release/CMakeCache.txt")
    flags=$(grep -o "\"command\": \"[^\"]*$1\"" "$root/build/release/compile_commands.json" |
        grep -o -- ' -\(O[0-9]\|m[a-z0-9=-]*\|f[a-z0-9=-]*\)\b' | sort -u | tr -d '\n')
    commit=$(git -C "$root" rev-parse --short HEAD)
    git -C "$root" diff --quiet HEAD -- bench server common rigs cmake || commit+=" and changes"
    printf '%s, one thread of %s, load %s; %s%s; commit %s' "$(date +%Y-%m-%d)" "$cpu" \
        "$(cut -d ' ' -f 1 /proc/loadavg)" "$("$compiler" --version | head -n 1)" "$flags" "$commit"
}
