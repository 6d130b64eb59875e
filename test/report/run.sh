#!/bin/bash
# Installs what is missing, builds, measures and writes the report. See usage below.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/../../launch/setup.sh"

SECTIONS=(static calculix locking dynamic stability tool cost)

usage() {
  echo "usage: test/report/run.sh [--quick] [SECTION...]"
  echo "  --quick  under five minutes, on smaller meshes; writes to build/report/ instead of test/report/"
  echo "  SECTION  of ${SECTIONS[*]}; all unless some are named. The others keep what they measured last."
}

folder="$ROOT/test/report"
quick=()
chosen=()
for argument in "$@"; do
  case $argument in
    --quick) quick=(--quick) folder="$BUILD/report" ;;
    -h | --help) usage && exit ;;
    *)
      [[ " ${SECTIONS[*]} " == *" $argument "* ]] || { usage >&2 && exit 2; }
      chosen+=("$argument")
      ;;
  esac
done

install_packages test
configure "$BUILD" -DCATKIN_ENABLE_TESTING=ON "-DINCISION_WERROR=${INCISION_WERROR:-OFF}"
compile "$BUILD" report
export INCISION_BATCH="$BUILD/devel/lib/incision/incision_batch"
export INCISION_REPORT="$BUILD/report" INCISION_OBJECTS="$BUILD/CMakeFiles"

status=0
mkdir -p "$folder/data"
for section in "${chosen[@]:-${SECTIONS[@]}}"; do
  echo "Section $section"
  program="$ROOT/test/report/$section/measure.py"
  [[ -x $program ]] || program="$BUILD/report/report_$section"
  "$program" "${quick[@]}" --output "$folder/data/$section.json" || status=1
done
"$ROOT/test/report/report.py" "$folder" "${SECTIONS[@]}"
((status == 0)) || echo "test/report/run.sh: some claims do not hold, see above" >&2
exit $status
