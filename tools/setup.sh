# Sourced by run.sh and test.sh: spool_setup KIND... installs the Debian packages of these kinds that are
# missing; spool_build PRESET [TARGET...] configures and builds.

spool_setup() {
  local kind package missing=()
  for kind in "$@"; do
    while read -r package; do
      [ "$(dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null)" = installed ] || missing+=("$package")
    done < <(sed -n "s/^$kind //p" tools/packages.txt)
  done
  [ ${#missing[@]} -eq 0 ] && return
  echo "Installing ${#missing[@]} Debian packages: ${missing[*]}" >&2
  local sudo=()
  if [ "$(id -u)" -ne 0 ]; then
    command -v sudo >/dev/null || { echo "Packages are missing and neither root nor sudo is at hand; install: ${missing[*]}" >&2; exit 69; }
    sudo=(sudo)
  fi
  "${sudo[@]}" apt-get update -qq &&
    "${sudo[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends "${missing[@]}" >&2 ||
    { echo "apt-get could not install the packages above; check the network and the package sources" >&2; exit 69; }
}

spool_build() {
  local preset=$1
  shift
  local log=build/$preset/configure.log
  if [ ! -f "build/$preset/build.ninja" ]; then
    mkdir -p "build/$preset"
    cmake --preset "$preset" >"$log" 2>&1 || { cat "$log" >&2; exit 70; }
  fi
  # At most one compiler a core, and no more than memory holds (about 1 GiB each).
  local jobs memory
  jobs=$(nproc)
  memory=$(awk '/MemAvailable/ {print int($2 / 1048576)}' /proc/meminfo)
  [ "${memory:-1}" -ge 1 ] || memory=1
  [ "$jobs" -le "$memory" ] || jobs=$memory
  cmake --build --preset "$preset" -j "$jobs" ${1:+--target "$@"} >&2 || exit 70
}
