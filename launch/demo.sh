#!/bin/bash
# Installs what is missing, builds, and shows the main job: a moving soft body is cut. See usage below.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/setup.sh"

PICTURE_TIMEOUT=180

usage() {
  echo "usage: launch/demo.sh [--scalpel | --two-arms] [--headless] [--picture FILE.png] [--build-only]"
  echo "  --scalpel           a scalpel that is drawn halfway over the organ, instead of the demo"
  echo "  --two-arms          forceps that lift a lobe of the organ, and a scalpel that cuts it off"
  echo "  --headless          without rviz (so also where there is no display); the demo ends by itself"
  echo "  --picture FILE.png  leaves a picture of the cut body as rviz draws it, without a display, and ends"
  echo "  --build-only        install and build, run nothing"
}

# What to launch, its arguments for no display, what it prints when there is nothing more to see, and the node, if any,
# with which it ends where there is no display.
launch=demo.launch
without_rviz=(headless:=true end:=false)
through="Summary of the demo"
last_node=demo
headless=
picture=
build_only=
while (($#)); do
  case $1 in
    --scalpel) launch=scalpel.launch without_rviz=(rviz:=false) through="is through; the tool stays" last_node= ;;
    --two-arms) launch=two_arms.launch without_rviz=(rviz:=false) through="is through; the tool stays" last_node= ;;
    --headless) headless=1 ;;
    --picture) (($# > 1)) || { usage >&2 && exit 2; } && picture=$(realpath -m "$2") && shift ;;
    --build-only) build_only=1 ;;
    -h | --help) usage && exit ;;
    *) echo "launch/demo.sh: there is no option $1" >&2 && usage >&2 && exit 2 ;;
  esac
  shift
done
[[ ${DISPLAY:-} ]] || headless=1

install_packages run rviz
[[ -f $BUILD/.configured_with ]] || configure "$BUILD" -DCATKIN_ENABLE_TESTING=OFF
[[ -x $BUILD/devel/lib/incision/incision_node ]] || echo "Compiling, which takes some ten minutes on two idle cores the first time"
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

# Waits for rviz, and then until all has happened: a screen without rviz's window has few colours.
take_picture() {
  local end=$((SECONDS + PICTURE_TIMEOUT)) drawn=
  while ((SECONDS < end)) && kill -0 "$roslaunch" 2>/dev/null; do
    sleep 0.3
    if [[ ! $drawn ]]; then
      import -window root "$run/picture.png"
      (($(identify -format %k "$run/picture.png") > 100)) && drawn=1 && sleep 3  # the window comes before the body
      continue
    fi
    grep -q "$through" "$run/log" || continue
    sleep 2  # a busy machine draws it later
    import -window root "$run/picture.png"
    mkdir -p "$(dirname "$picture")"
    mv "$run/picture.png" "$picture"
    echo "The picture is in $picture"
    return
  done
  fail "rviz has drawn nothing, so there is no picture"
}

# Waits until roslaunch says that this node has ended, well or not, or that another has died. Were the node one that the
# launch requires, roslaunch would call its end a death, in red.
await_node() {
  while kill -0 "$roslaunch" 2>/dev/null &&
    ! grep -q -e "\[$1-[0-9]*\] process has" -e "process has died" "$run/log"; do
    sleep 0.3
  done
}

enter_ros
# What the nodes and roslaunch itself say comes at once, not in blocks of many lines: the end is read from it.
export ROSCONSOLE_STDOUT_LINE_BUFFERED=1 PYTHONUNBUFFERED=1
arguments=()
if [[ $picture ]]; then
  start_display
elif [[ $headless ]]; then
  arguments=("${without_rviz[@]}")
fi

touch "$run/log"
roslaunch --port "${ROS_MASTER_URI##*:}" incision "$launch" "${arguments[@]}" > >(tee -i "$run/log") 2>&1 &
roslaunch=$!
pids+=("$roslaunch")
if [[ $picture ]]; then
  take_picture
  kill "$roslaunch"
elif [[ $headless && $last_node ]]; then
  await_node "$last_node"
  kill "$roslaunch" 2>/dev/null || true
fi

status=0
wait "$roslaunch" || status=$?
# roslaunch itself ends well when a node did not.
if grep -q "process has died" "$run/log"; then
  fail "a node has died, see above"
fi
exit $status
