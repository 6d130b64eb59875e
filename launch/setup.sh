# Shared by launch/demo.sh, test/run.sh and test/benchmark/run.sh, which source it: packages, build, ROS environment.
ROOT="$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)"
BUILD="$ROOT/build"

fail() {
  echo "$(basename "$0"): $*" >&2
  exit 1
}

# install_packages SECTION...: installs what is missing of these sections of config/packages.txt.
install_packages() {
  local wanted missing=() package sudo=()
  wanted=$(awk -v sections=" $* " '/^# [a-z]+:/ { chosen = index(sections, " " substr($2, 1, length($2) - 1) " ") }
    chosen && /^[a-z]/' "$ROOT/config/packages.txt")
  for package in $wanted; do
    [[ $(dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null) == installed ]] || missing+=("$package")
  done
  ((${#missing[@]})) || return 0

  if ((EUID != 0)); then
    command -v sudo >/dev/null || fail "these packages are missing, and only root can install them: ${missing[*]}"
    sudo=(sudo)
    # Without a terminal sudo cannot ask for a password.
    [[ -t 0 ]] || sudo+=(-n)
    "${sudo[@]}" true || fail "these packages are missing, and sudo was refused: ${missing[*]}"
  fi
  echo "Installing ${#missing[@]} missing packages: ${missing[*]}"
  "${sudo[@]}" apt-get update -q
  "${sudo[@]}" env DEBIAN_FRONTEND=noninteractive \
    apt-get install -q -y --no-install-recommends "${missing[@]}" </dev/null
}

# configure FOLDER [-DOPTION=VALUE]...: configures a build folder unless it was configured with these options before.
# A newer checkout may have targets that make would not know of.
configure() {
  local folder="$1" stamp="$1/.configured_with" newer
  shift
  newer=$(find "$ROOT/CMakeLists.txt" "$ROOT/config/cmake" -newer "$stamp" 2>/dev/null || echo all)
  [[ -z $newer && -f $folder/CMakeCache.txt && $(cat "$stamp") == "$*" ]] && return
  cmake -S "$ROOT" -B "$folder" "$@" && echo "$*" >"$stamp"
}

# compile FOLDER TARGET...: make finds out by itself what is out of date. One at a time: two would write one file.
compile() {
  local folder="$1"
  shift
  flock "$folder" cmake --build "$folder" --parallel "$(nproc)" --target "$@"
}

# Makes this shell see the build, and a ROS master of its own on this machine only.
enter_ros() {
  local port
  set +u
  source "$BUILD/devel/setup.bash"
  set -u
  port=$(/usr/bin/python3 -c 'import socket; s = socket.socket(); s.bind(("127.0.0.1", 0)); print(s.getsockname()[1])')
  unset ROS_HOSTNAME
  export ROS_IP=127.0.0.1 ROS_MASTER_URI="http://127.0.0.1:$port"
}
