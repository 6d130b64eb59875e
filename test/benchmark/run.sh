#!/bin/bash
# Installs what is missing, builds the benchmarks, runs them, draws the plot and prints the tables. See usage below.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/../../launch/setup.sh"

usage() {
  echo "usage: test/benchmark/run.sh [--quick] [--large]"
  echo "  --quick  a few minutes: fewer steps, no other programs at 98,304 elements, the plot stays in the build folder"
  echo "  --large  also a million elements"
}

folder="$BUILD/benchmark"
picture="$ROOT/config/pictures/step_times.png"
for argument in "$@"; do
  case $argument in
    --quick) picture="$folder/step_times.png" ;;
    --large) ;;
    -h | --help) usage && exit ;;
    *) usage >&2 && exit 2 ;;
  esac
done

install_packages benchmark
configure "$folder" -DINCISION_BENCHMARK=ON -DINCISION_ROS=OFF
compile "$folder" benchmarks

"$folder/kernels_benchmark"
"$folder/step_benchmark" "$@" --json "$folder/steps.json"
"$ROOT/test/benchmark/plot_steps.py" "$folder/steps.json" "$picture"
