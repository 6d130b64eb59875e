#!/bin/bash
# Installs what is missing, builds and tests. See usage below.
set -uo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/../launch/setup.sh"

usage() {
  echo "usage: test/run.sh [--full | PART...] [--minutes N] [--build-only]"
  echo "  --full        all parts, in this order; without it and without a PART the first one"
  echo "  --minutes N   begins no part that would hardly end within N minutes from the start, and says what it left out"
  echo "  --build-only  install and build, run nothing"
  echo "  PART          of:"
  echo "    quick       what takes some minutes"
  echo "    sanitizers  the core's quick tests under the address and undefined behaviour sanitizers"
  echo "    threads     the core's parallel parts under the thread sanitizer"
  echo "    fuzzers     a few seconds each"
  echo "    slow        tests that take longer"
  echo "    realtime    tests that need a machine that does nothing else"
  echo "    report      the claims of the report"
}

PARTS=(quick sanitizers threads fuzzers slow realtime report)

# What each takes on two cores [min], build included.
declare -A MINUTES=([quick]=12 [sanitizers]=35 [threads]=5 [fuzzers]=6 [slow]=25 [realtime]=2 [report]=8)

chosen=()
minutes=
build_only=
while (($#)); do
  case $1 in
    --full) chosen=("${PARTS[@]}") ;;
    --minutes) [[ ${2:-} =~ ^[0-9]+$ ]] || { usage >&2 && exit 2; } && minutes=$2 && shift ;;
    --build-only) build_only=1 ;;
    -h | --help) usage && exit ;;
    *)
      [[ " ${PARTS[*]} " == *" $1 "* ]] || { usage >&2 && exit 2; }
      chosen+=("$1")
      ;;
  esac
  shift
done
((${#chosen[@]})) || chosen=(quick)

werror="-DINCISION_WERROR=${INCISION_WERROR:-OFF}"
passed=0
failed=0

# prepare FOLDER TARGETS [-DOPTION=VALUE]...
prepare() {
  local folder="$1" targets="$2"
  shift 2
  # shellcheck disable=SC2086 # several targets
  configure "$folder" "$@" "$werror" && compile "$folder" $targets
}

# prepare_node TARGETS: the build that has everything.
prepare_node() {
  prepare "$BUILD" "$1" -DCATKIN_ENABLE_TESTING=ON
}

# prepare_core NAME TARGETS [-DOPTION=VALUE]...: a build without ROS by clang, which brings the fuzzers.
prepare_core() {
  prepare "$BUILD/$1" "$2" -DCMAKE_CXX_COMPILER=clang++ -DCMAKE_BUILD_TYPE=Debug "-DCMAKE_CXX_FLAGS_DEBUG=-O1 -g1" \
    -DINCISION_ROS=OFF "${@:3}"
}

prepare_sanitized() {
  prepare_core sanitized "$1" -DINCISION_SANITIZE=address,undefined -DINCISION_FUZZ=ON
}

# run_tests FOLDER LABEL [COUNT]: runs the tests of a label, COUNT at a time, and counts those that pass and fail.
run_tests() {
  local log="$1/tests.log" summary status=0
  [[ $build_only ]] && return
  (cd "$1" && ctest --output-on-failure --no-tests=error --output-log "$log" -L "^$2\$" --parallel "${3:-$(nproc)}" \
    </dev/null) || status=1
  summary=$(sed -nE 's/.* tests passed, ([0-9]+) tests? failed out of ([0-9]+)$/\1 \2/p' "$log")
  [[ $summary ]] || return 1
  failed=$((failed + ${summary% *}))
  passed=$((passed + ${summary#* } - ${summary% *}))
  return $status
}

# The tests of the node mostly wait, so there are more of them at a time than processors.
quick() { prepare_node "all tests" && run_tests "$BUILD" quick $((2 * $(nproc))); }
sanitizers() { prepare_sanitized tests && run_tests "$BUILD/sanitized" quick; }
threads() {
  prepare_core threads thread_tests -DINCISION_SANITIZE=thread -DCMAKE_UNITY_BUILD=OFF &&
    run_tests "$BUILD/threads" threads 1
}
fuzzers() { prepare_sanitized fuzzers && run_tests "$BUILD/sanitized" fuzz; }
slow() { prepare_node "all tests full_tests" && run_tests "$BUILD" full; }
realtime() { prepare_node "all tests" && run_tests "$BUILD" realtime 1; }
report() { prepare_node report && run_tests "$BUILD" report; }

sections=(run test)
[[ ${chosen[*]} == quick ]] || sections+=(full)
install_packages "${sections[@]}" || exit

broken=()
left_out=()
for part in "${chosen[@]}"; do
  if [[ $minutes ]] && ((SECONDS + 60 * MINUTES[$part] > 60 * minutes)); then
    left_out+=("$part")
    continue
  fi
  echo "Part $part"
  before=$failed
  "$part" && continue
  broken+=("$part")
  # What could not be built or run counts as one.
  ((failed > before)) || failed=$((failed + 1))
done

((${#left_out[@]} == 0)) || echo "Left out, since they would not end within $minutes minutes: ${left_out[*]}"
((${#broken[@]} == 0)) || echo "test/run.sh: not all is well in: ${broken[*]}; see above" >&2
[[ $build_only ]] || echo "$passed passed, $failed failed"
((${#broken[@]} == 0))
