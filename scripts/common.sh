# Sourced by the other scripts: environment, packages, builds and their logs.
# shellcheck shell=bash
set -euo pipefail

repo=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
readonly repo
cores=$(nproc)
readonly cores

# The system's programs, Python modules and libraries alone: a pyenv, conda or ROS workspace in
# the caller's environment has others that do not fit the Debian packages.
export PATH=/usr/sbin:/usr/bin:/sbin:/bin
unset PYTHONHOME PYTHONPATH CMAKE_PREFIX_PATH PKG_CONFIG_PATH LD_LIBRARY_PATH ROS_PACKAGE_PATH
export LC_ALL=C.UTF-8

# Background jobs become process groups of their own, which stop_children ends as a whole.
set -m
children=()

# Quietly: the shell reports jobs that end by a signal.
stop_child() {
  {
    kill -TERM -- "-$1"
    wait "$1"
  } 2> /dev/null || true
}

stop_children() {
  local child
  for child in "${children[@]}"; do stop_child "$child"; done
  children=()
}

trap stop_children EXIT
trap 'exit 130' INT
trap 'exit 143' TERM

say() { printf '%s\n' "$*"; }

fail() {
  printf '%s: %s\n' "$(basename "$0")" "$*" >&2
  exit 1
}

# The last "[ 42%]" of a make log, as " 42 %"; nothing before there is one.
progress_of() {
  tail -c 4096 "$1" | grep -o '^\[ *[0-9]*%\]' | tail -n 1 | sed 's/[^0-9]//g; s/$/ %/' || true
}

# run_logged LOG WHAT COMMAND...: runs the command with its output in LOG and shows how far it
# is; a failure ends the script with the end of the log.
run_logged() {
  local log=$1 what=$2 started=$SECONDS status=0 child
  shift 2
  mkdir -p "$(dirname "$log")"
  : > "$log"
  "$@" > "$log" 2>&1 < /dev/null &
  child=$!
  children+=("$child")
  show_progress "$child" "$log" "$what"
  wait "$child" || status=$?
  unset 'children[-1]'
  if ((status != 0)); then
    say "$what: FAILED with status $status; the end of $log:" >&2
    tail -n 30 "$log" >&2
    exit 1
  fi
  say "$what: done in $((SECONDS - started)) s"
}

# A line that is rewritten every second on a terminal, one every half minute elsewhere.
show_progress() {
  local child=$1 log=$2 what=$3 started=$SECONDS next=30 elapsed
  while kill -0 "$child" 2> /dev/null; do
    elapsed=$((SECONDS - started))
    if [[ -t 1 ]]; then
      printf '\r%s: %s s %s\033[K' "$what" "$elapsed" "$(progress_of "$log")"
    elif ((elapsed >= next)); then
      say "$what: $elapsed s $(progress_of "$log")"
      next=$((next + 30))
    fi
    sleep 0.2
  done
  if [[ -t 1 ]]; then printf '\r\033[K'; fi
}

# The packages of the named groups of scripts/packages.
packages_of() {
  local group
  for group in "$@"; do
    sed -n "/^\[$group\]\$/,/^\$/p" "$repo/scripts/packages" | grep -v '^\[' || true
  done | sed '/^$/d' | sort -u
}

is_installed() {
  [[ $(dpkg-query -W -f '${db:Status-Status}' "$1" 2> /dev/null) == installed ]]
}

# as_root LOG WHAT COMMAND...: run_logged with the rights to install packages.
as_root() {
  local log=$1 what=$2
  shift 2
  if ((EUID == 0)); then
    run_logged "$log" "$what" env DEBIAN_FRONTEND=noninteractive "$@"
  else
    command -v sudo > /dev/null || fail "needs root or sudo for: $*"
    sudo -v
    run_logged "$log" "$what" sudo -n DEBIAN_FRONTEND=noninteractive "$@"
  fi
}

update_package_lists() {
  as_root "$repo/build/apt-update.log" "Updating the package lists" apt-get update
}

# Installs what is missing of the named groups of scripts/packages.
install_packages() {
  local package missing=()
  for package in $(packages_of "$@"); do
    is_installed "$package" || missing+=("$package")
  done
  if ((${#missing[@]} == 0)); then
    say "All packages are installed."
    return
  fi
  say "Installing ${#missing[@]} Debian packages and what they need: ${missing[*]}"
  command -v apt-get > /dev/null || fail "no apt-get here; install the packages above by hand"
  update_package_lists
  as_root "$repo/build/apt-install.log" "Installing packages" \
    apt-get install --yes --no-install-recommends "${missing[@]}"
}

# configure FOLDER OPTIONS...: with CMake.
configure() {
  run_logged "$1/configure.log" "Configuring $(basename "$1")/" \
    cmake -S "$repo" -B "$1" -DPYTHON_EXECUTABLE=/usr/bin/python3 \
    -DPython3_EXECUTABLE=/usr/bin/python3 "${@:2}"
}

# compile FOLDER TARGETS...: of what was configured.
compile() {
  run_logged "$1/build.log" "Building $(basename "$1")/" \
    cmake --build "$1" --parallel "$cores" --target "${@:2}"
}

# build FOLDER OPTIONS...: configures and builds everything, tests included.
build() {
  local targets=(all)
  configure "$@"
  # catkin keeps the programs of rostests out of `all`.
  if grep -q '^tests:' "$1/Makefile"; then targets+=(tests); fi
  compile "$1" "${targets[@]}"
}

# Options of a sanitized build: linked quickly, and with the plain and the best SIMD target of this
# machine alone, since a kernel of all of them takes minutes to compile.
sanitized_options() {
  local omit="HWY_SSE4|HWY_AVX3|HWY_AVX3_DL"
  if grep -q -w avx512bw /proc/cpuinfo; then omit="HWY_SSE4|HWY_AVX2|HWY_AVX3_DL"; fi
  printf '%s\n' -DCMAKE_BUILD_TYPE=RelWithDebInfo -DBUILD_SHARED_LIBS=ON \
    "-DSTEREO_SGMP_OMIT_TARGETS=$omit"
}

# build_release OPTIONS...: the programs, without the tests, in build/.
build_release() {
  build "$repo/build" -DCMAKE_BUILD_TYPE=Release -DSTEREO_SGMP_WARNINGS_AS_ERRORS=ON \
    -DSTEREO_SGMP_BUILD_TESTS=OFF "$@"
}

# make_real_scenes FOLDER: the pairs that Debian packages carry, in FOLDER/scenes.
make_real_scenes() {
  # An image of a machine may have packages but no package lists to download others by.
  if [[ ! -e $1/scenes/aloe/calib.txt ]] && ! apt-cache show opencv-doc > /dev/null 2>&1; then
    update_package_lists
  fi
  run_logged "$1/real_scenes.log" "Extracting the real pairs from python3-skimage, opencv-doc" \
    /usr/bin/python3 "$repo/scripts/demo_tools/real_scenes.py" "$1/scenes"
}

# start_roscore FOLDER: the ROS environment of build/, and a master of our own that disturbs no
# other, with its files in FOLDER.
start_roscore() {
  local folder=$1
  set +u
  # shellcheck source=/dev/null
  source "$repo/build/devel/setup.bash"
  set -u
  local port
  port=$(/usr/bin/python3 -c 'import socket; s = socket.socket(); s.bind(("localhost", 0));
print(s.getsockname()[1])')
  unset ROS_IP ROS_NAMESPACE
  export ROS_HOSTNAME=localhost ROS_MASTER_URI=http://localhost:$port
  export ROS_HOME=$folder/ros_home ROS_LOG_DIR=$folder/ros_log
  roscore -p "$port" > "$folder/roscore.log" 2>&1 < /dev/null &
  children+=("$!")
  local tries=0
  until rosparam list > /dev/null 2>&1; do
    ((++tries < 50)) || fail "roscore does not answer; see $folder/roscore.log"
    sleep 0.2
  done
}
