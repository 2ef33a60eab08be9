# Sourced by the project's scripts: the project's folder, steps with their times, and endings that
# say what to do. The caller has set -euo pipefail.
# shellcheck shell=bash

root="$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd -P)"
readonly root
readonly script="${0##*/}"

# Says what went wrong and what to do, then ends the script.
fail()
{
  printf '%s: %s\n' "$script" "$*" >&2
  exit 1
}

# Now, in tenths of a second.
tenths()
{
  local -r microseconds=${EPOCHREALTIME/[.,]/}
  printf '%d' $((microseconds / 100000))
}

# step "What it does" command...: runs the command and prints how long it took. A command that fails
# ends the step with the same status.
step()
{
  local -r title=$1
  shift
  printf '==> %s\n' "$title"
  local from taken status=0
  from=$(tenths)
  "$@" || status=$?
  taken=$(($(tenths) - from))
  printf '==> %s: %s %d.%d s\n' "$title" "$( ((status == 0)) && echo done, || echo failed, )" \
    $((taken / 10)) $((taken % 10))
  return "$status"
}

# How many compilers may run at once: one a core, and 1.5 GB of free memory for each, because a file
# that includes VTK or Qt takes nearly that much.
jobs_for_building()
{
  local cores free_kB jobs
  cores=$(nproc)
  free_kB=$(awk '/^MemAvailable:/ { print $2 }' /proc/meminfo)
  # A container may be allowed less memory than the machine has.
  local -r limit=/sys/fs/cgroup/memory.max
  if [[ -r $limit && $(<"$limit") =~ ^[0-9]+$ ]]; then
    local -r limit_kB=$(($(<"$limit") / 1024))
    if ((limit_kB < free_kB)); then free_kB=$limit_kB; fi
  fi
  jobs=$((free_kB / 1500000))
  if ((jobs > cores)); then jobs=$cores; fi
  if ((jobs < 1)); then jobs=1; fi
  printf '%d' "$jobs"
}

# Git refuses to read a folder that belongs to somebody else. The build only asks it for the name of
# the commit, so for this run alone the project's folder is declared safe.
trust_own_folder()
{
  local -r count=${GIT_CONFIG_COUNT:-0}
  export GIT_CONFIG_COUNT=$((count + 1))
  export "GIT_CONFIG_KEY_$count=safe.directory" "GIT_CONFIG_VALUE_$count=$root"
}

# What a configured build folder depends on that ninja does not watch: place, presets, commit.
configuration_stamp()
{
  echo "$root"
  cksum <"$root/CMakePresets.json"
  git -C "$root" describe --always --dirty --abbrev=12 2>/dev/null || echo "no commit"
}

# configure <preset>: runs CMake where something changed that ninja would not notice.
configure()
{
  local -r folder=$root/build/$1
  local -r log=$root/build/$1-configure.log stamp=$folder/configured-for
  if [[ -f $folder/build.ninja && -f $stamp && $(configuration_stamp) == "$(<"$stamp")" ]]; then
    return
  fi
  mkdir -p "$folder" 2>/dev/null || true
  if [[ ! -w $folder ]]; then
    fail "$folder cannot be written. Run this as a user who may write there, or copy the project to a place of your own."
  fi
  # A build folder that came along from another place remembers that place.
  local -r cache=$folder/CMakeCache.txt
  if [[ -f $cache ]] && ! grep -qxF "CMAKE_HOME_DIRECTORY:INTERNAL=$root" "$cache"; then
    rm -rf "${folder:?}"
    mkdir -p "$folder"
  fi
  rm -f "$stamp"
  (cd "$root" && cmake --preset "$1") >"$log" 2>&1 || {
    tail -n 25 "$log" >&2
    fail "CMake could not configure preset $1; its last lines are above, all of them in $log."
  }
  configuration_stamp >"$stamp"
}

# build <preset>: everything in it.
build()
{
  (cd "$root" && cmake --build --preset "$1" --parallel "$(jobs_for_building)") ||
    fail "Preset $1 does not build; the compiler's words are above. If it says 'Killed', memory ran out: close programs and run this again, it goes on where it stopped."
}
