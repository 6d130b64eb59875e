#!/bin/bash
# Installs what is missing, builds, and shows the main job: a moving soft body is cut. See usage below.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/setup.sh"

# What the demo's node prints first when it is through.
SUMMARY="Summary of the demo"
PICTURE_TIMEOUT=180

usage() {
  echo "usage: launch/demo.sh [--headless] [--picture FILE.png] [--build-only]"
  echo "  --headless          without rviz; ends by itself (so also where there is no display)"
  echo "  --picture FILE.png  leaves a picture of the cut body as rviz draws it, without a display, and ends"
  echo "  --build-only        install and build, run nothing"
}

headless=
picture=
build_only=
while (($#)); do
  case $1 in
    --headless) headless=1 ;;
    --picture) (($# > 1)) || { usage >&2 && exit 2; } && picture=$(realpath -m "$2") && shift ;;
    --build-only) build_only=1 ;;
    -h | --help) usage && exit ;;
    *) usage >&2 && exit 2 ;;
  esac
  shift
done
[[ ${DISPLAY:-} ]] || headless=1

install_packages run
[[ -f $BUILD/.configured_with ]] || configure "$BUILD" -DCATKIN_ENABLE_TESTING=OFF
compile "$BUILD" all
[[ $build_only ]] && exit

run=$(mktemp -d)
pids=()

stop() {
  trap - EXIT
  # The youngest first: rviz wants its display to the end.
  local i
  for ((i = ${#pids[@]} - 1; i >= 0; i--)); do
    kill "${pids[i]}" 2>/dev/null || true
    wait "${pids[i]}" 2>/dev/null || true
  done
  rm -rf "$run"
}
trap stop EXIT
trap 'exit 130' INT
trap 'exit 143' TERM HUP

# A display in memory, drawn to by software.
start_display() {
  mkfifo "$run/display"
  Xvfb -displayfd 3 -screen 0 1280x800x24 +extension GLX -nolisten tcp 3>"$run/display" 2>/dev/null &
  pids+=($!)
  DISPLAY=":$(head -n 1 "$run/display")"
  mkdir -m 700 "$run/xdg"
  export DISPLAY LIBGL_ALWAYS_SOFTWARE=1 QT_X11_NO_MITSHM=1 XDG_RUNTIME_DIR="$run/xdg"
}

# Waits for the summary, then for rviz: a screen without its window has few colours. The window comes before the body.
take_picture() {
  local end=$((SECONDS + PICTURE_TIMEOUT))
  while ((SECONDS < end)) && kill -0 "$roslaunch" 2>/dev/null; do
    sleep 1
    grep -q "$SUMMARY" "$run/log" || continue
    import -window root "$run/picture.png"
    (($(identify -format %k "$run/picture.png") > 100)) || continue
    sleep 3
    import -window root "$run/picture.png"
    mkdir -p "$(dirname "$picture")"
    mv "$run/picture.png" "$picture"
    echo "The picture is in $picture"
    return
  done
  fail "rviz has drawn nothing, so there is no picture"
}

enter_ros
arguments=(rviz:=true headless:=false)
if [[ $picture ]]; then
  start_display
elif [[ $headless ]]; then
  arguments=(rviz:=false headless:=true)
fi

touch "$run/log"
roslaunch --port "${ROS_MASTER_URI##*:}" incision demo.launch "${arguments[@]}" > >(tee -i "$run/log") 2>&1 &
roslaunch=$!
pids+=("$roslaunch")
if [[ $picture ]]; then
  take_picture
  kill "$roslaunch"
fi

status=0
wait "$roslaunch" || status=$?
# roslaunch itself ends well when a node did not.
if grep -q "process has died" "$run/log"; then
  fail "a node has died, see above"
fi
exit $status
