#!/usr/bin/env bash
# Draws the figures of the paper that the project began with, from runs of chain_lab.
set -euo pipefail
source "$(dirname "$0")/../cmake/setup.sh"
source "$(dirname "$0")/made_by.sh"

usage() {
    cat <<'END'
usage: bench/make_seed_figures.sh [--out DIR] [--draw-only]

Builds chain_lab and makes, in docs/charts/seed or DIR, the drawings and data of docs/seed_figures.md; what
was measured of each shape is printed. Takes some seconds.

  --out DIR    where to
  --draw-only  no runs: draws what the data have
  -h, --help   this text
END
}

out=$root/docs/charts/seed
part=()
while (($#)); do
    case $1 in
    --out) out=${2:?"--out: a folder is missing"} && shift ;;
    --draw-only) part=("$1") ;;
    -h | --help) usage && exit ;;
    *) usage >&2 && exit 2 ;;
    esac
    shift
done

install_packages
build release chain_lab
"$root/build/release/bin/chain_lab" shapes "$root/bench/cases/seed_figures.json" --out "$out" \
    --note "$(made_by bench/methods/pbd.cpp)" ${part[@]+"${part[@]}"}
say "figures and data are in $out"
