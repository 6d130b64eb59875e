#!/bin/bash
# Installs what is missing, builds the benchmarks, runs them, draws the plots and prints the tables. See usage below.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/../../launch/setup.sh"

usage() {
  echo "usage: test/benchmark/run.sh [--quick] [--large]"
  echo "  --quick  a few minutes: fewer steps, no other programs at 98,304 elements, the plots stay in the build folder"
  echo "  --large  also a million elements and more"
}

folder="$BUILD/benchmark"
pictures="$ROOT/config/pictures"
quick=()
for argument in "$@"; do
  case $argument in
    --quick) quick=(--quick) pictures="$folder" ;;
    --large) ;;
    -h | --help) usage && exit ;;
    *) usage >&2 && exit 2 ;;
  esac
done

install_packages run test full benchmark
configure "$folder" -DINCISION_BENCHMARK=ON -DINCISION_ROS=OFF
compile "$folder" benchmarks

"$folder/kernels_benchmark"
"$folder/step_benchmark" "$@" --json "$folder/steps.json"
"$ROOT/test/benchmark/plot_steps.py" "$folder/steps.json" "$pictures/step_times.png" "$pictures/cut_hitch.png"

# The node's part.
configure "$BUILD" -DCATKIN_ENABLE_TESTING=ON "-DINCISION_WERROR=${INCISION_WERROR:-OFF}"
compile "$BUILD" incision_node incision_scalpel
enter_ros
"$ROOT/test/benchmark/latency.py" "${quick[@]}" "$folder/latency.json" "$pictures/tool_latency.png"
