#!/usr/bin/env bash
# Makes the charts of chain_lab and their data anew.
set -euo pipefail
source "$(dirname "$0")/../cmake/setup.sh"
source "$(dirname "$0")/made_by.sh"

usage() {
    cat <<'END'
usage: bench/make_charts.sh [--out DIR] [--resume | --draw-only]

Builds chain_lab and makes, in docs/charts or DIR:
  work_precision_*.csv, *.svg, cost_nodes.svg   error against cost, cost against links
  stability_*.csv, *.svg                        where each method stays bounded
  converge.csv, converge.svg                    error against iterations and time in one step

  --out DIR    where to
  --resume     goes on where work was broken off: only runs that the data do not have yet
  --draw-only  no runs: draws what the data have
  -h, --help   this text

Takes about a quarter of an hour on one core; an idle machine gives the best timings. The tables of least
costs and of stable cells are printed at the end of each part.
END
}

out=$root/docs/charts
part=()
while (($#)); do
    case $1 in
    --out) out=${2:?"--out: a folder is missing"} && shift ;;
    --resume | --draw-only) part=("$1") ;;
    -h | --help) usage && exit ;;
    *) usage >&2 && exit 2 ;;
    esac
    shift
done

install_packages
build release chain_lab
lab=$root/build/release/bin/chain_lab
cases=$root/bench/cases
mkdir -p "$out"

note=$(made_by bench/methods/pbd.cpp)

say "error against cost"
"$lab" compare "$cases/suite.json" --out "$out" --note "$note" ${part[@]+"${part[@]}"}
say "stability"
"$lab" stability "$cases/stability.json" --out "$out" --note "$note" ${part[@]+"${part[@]}"}
if [[ ! (${part-} == --resume && -e $out/converge.csv) ]]; then
    say "error against iterations"
    [[ ${part-} == --resume ]] && part=()
    "$lab" converge "$cases/swing.json" "$cases/hang.json" --out "$out" --note "$note" ${part[@]+"${part[@]}"}
fi
say "charts and data are in $out"
