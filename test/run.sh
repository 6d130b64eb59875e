#!/bin/bash
# Installs what is missing, builds and tests. See usage below.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/../launch/setup.sh"

usage() {
  echo "usage: test/run.sh [--full] [--build-only]"
  echo "  --full        run all tests, not only the quick ones"
  echo "  --build-only  install and build, run nothing"
}

selection=(-LE full)
build_only=
for argument in "$@"; do
  case $argument in
    --full) selection=() ;;
    --build-only) build_only=1 ;;
    -h | --help) usage && exit ;;
    *) usage >&2 && exit 2 ;;
  esac
done

install_packages test

werror="-DINCISION_WERROR=${INCISION_WERROR:-OFF}"
configure "$BUILD" -DCATKIN_ENABLE_TESTING=ON "$werror"
compile "$BUILD" all tests

# Clang brings the fuzzers, so the sanitizers use it too; Debug keeps the assertions.
sanitized="$BUILD/sanitized"
configure "$sanitized" -DCMAKE_CXX_COMPILER=clang++ -DCMAKE_BUILD_TYPE=Debug "-DCMAKE_CXX_FLAGS_DEBUG=-O1 -g1" \
  -DINCISION_ROS=OFF -DINCISION_SANITIZE=ON -DINCISION_FUZZ=ON "$werror"
compile "$sanitized" tests

[[ $build_only ]] && exit

run_tests() {
  (cd "$1" && ctest --output-on-failure --parallel "$(nproc)" "${@:2}" </dev/null)
}

status=0
echo "Tests of the core under the address and undefined behaviour sanitizers, and fuzzers"
run_tests "$sanitized" -LE full || status=1
echo "Tests"
run_tests "$BUILD" "${selection[@]}" || status=1
((status == 0)) || echo "test/run.sh: tests failed, see above" >&2
exit $status
