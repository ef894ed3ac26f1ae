#!/usr/bin/env bash
# Makes the tables of whole anchorings and of ships that lie at anchor anew.
set -euo pipefail
source "$(dirname "$0")/../cmake/setup.sh"
source "$(dirname "$0")/made_by.sh"

usage() {
    cat <<'END'
usage: bench/make_anchorings.sh [--out DIR] [coverage] [fouling] [anchoring] [sheering]

Builds and makes, in docs/charts or DIR, all of these or those named:
  coverage.csv                whether the published error covers the one that is made; half an hour on two cores
  fouling.csv                 how often an anchor that is let go comes to lie foul; 10 min on two cores
  anchoring.csv               cost and error by length of link and by the model's policy; 10 min
  sheering.csv, sheering.svg  how every ship sheers; 5 min

  --out DIR    where to
  -h, --help   this text

Costs in anchoring.csv and coverage.csv are processor time; an idle machine gives the best.
END
}

out=$root/docs/charts
tables=()
while (($#)); do
    case $1 in
    --out) out=${2:?"--out: a folder is missing"} && shift ;;
    coverage | fouling | anchoring | sheering) tables+=("$1") ;;
    -h | --help) usage && exit ;;
    *) usage >&2 && exit 2 ;;
    esac
    shift
done
((${#tables[@]})) || tables=(coverage fouling anchoring sheering)

install_packages
build release error_coverage fouling anchoring_chart sheering_chart
bin=$root/build/release/bin
mkdir -p "$out"

for table in "${tables[@]}"; do
    say "$table"
    note=$(made_by server/physics/chain/chain.cpp)
    case $table in
    coverage) "$bin/error_coverage" --luck --out "$out/coverage.csv" --note "$note" ;;
    fouling) "$bin/fouling" --out "$out/fouling.csv" --note "$note" ;;
    anchoring) "$bin/anchoring_chart" --out "$out/anchoring.csv" --note "$note" ;;
    sheering) "$bin/sheering_chart" --out "$out/sheering.csv" --chart "$out/sheering.svg" --note "$note" ;;
    esac
done
say "tables are in $out"
