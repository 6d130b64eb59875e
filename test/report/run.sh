#!/bin/bash
# Installs what is missing, builds, measures, checks the claims and writes the report. See usage below.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/../../launch/setup.sh"

SECTIONS=(static calculix benchmark locking regions dynamic contact stability tool cost)

usage() {
  echo "usage: test/report/run.sh [--quick | --publish] [SECTION...]"
  echo "  --quick    under five minutes, on smaller meshes; writes to build/report/quick/ instead of build/report/"
  echo "  --publish  also replaces what was measured in test/report/README.md and its plots"
  echo "  SECTION    of ${SECTIONS[*]}; all unless some are named. The others keep what they measured last."
}

export INCISION_REPORT="$BUILD/report"
quick=()
publish=
chosen=()
for argument in "$@"; do
  case $argument in
    --quick) quick=(--quick) INCISION_REPORT="$BUILD/report/quick" ;;
    --publish) publish=1 ;;
    -h | --help) usage && exit ;;
    *)
      [[ " ${SECTIONS[*]} " == *" $argument "* ]] || { usage >&2 && exit 2; }
      chosen+=("$argument")
      ;;
  esac
done
[[ $publish && ${#quick[@]} -gt 0 ]] && { usage >&2 && exit 2; }

install_packages run test full
configure "$BUILD" -DCATKIN_ENABLE_TESTING=ON "-DINCISION_WERROR=${INCISION_WERROR:-OFF}"
compile "$BUILD" report
export INCISION_BATCH="$BUILD/devel/lib/incision/incision_batch" INCISION_PROGRAMS="$BUILD/report"

cd "$ROOT/test/report"
status=0
for section in "${chosen[@]:-${SECTIONS[@]}}"; do
  echo "Section $section"
  ./measure.py "${quick[@]}" "$INCISION_REPORT" "$section"
  /usr/bin/python3 -m unittest "$section.claims" || status=1
done
./report.py "$INCISION_REPORT" "${SECTIONS[@]}"
if [[ $publish ]]; then
  cp "$INCISION_REPORT/README.md" .
  cp "$INCISION_REPORT"/plots/*.png plots/
fi
((status == 0)) || echo "test/report/run.sh: some claims do not hold, see above" >&2
exit $status
