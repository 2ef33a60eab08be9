# SPDX-License-Identifier: BSD-3-Clause

# Sourced by the project's scripts: the project's folder, steps with their durations, and error
# messages. The caller has set -euo pipefail. A function cannot have a local variable of the name of a caller's
# read-only one, so the local names below are not among theirs.
# shellcheck shell=bash

root="$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd -P)"
readonly root
readonly script="${0##*/}"
# With it ccache reads a precompiled header of 200 MB once, and not for every file that is compiled with it. It locks a
# file for that: one of this folder, because a lock that a stopped machine left would make every later build wait.
export CCACHE_INODECACHE=1 CCACHE_TEMPDIR=$root/build/ccache

# Prints an error message with the remedy and ends the script.
fail()
{
  printf '%s: %s\n' "$script" "$*" >&2
  exit 1
}

# Current time, in tenths of a second.
tenths()
{
  local -r microseconds=${EPOCHREALTIME/[.,]/}
  printf '%d' $((microseconds / 100000))
}

# step "Description" command...: runs the command and prints its duration. If the command fails, the
# step ends with its status.
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

# Time of day in UTC, as in ISO 8601.
now()
{
  TZ=UTC printf '%(%FT%TZ)T' -1
}

# commit_built: what is in the folder: the commit, and "-dirty" if a file of it was changed.
commit_built()
{
  git -C "$root" describe --always --dirty --abbrev=40 2>/dev/null || echo "no commit-dirty"
}

# clone_into <folder>: the last commit, in a clone that keeps what was built there.
clone_into()
{
  if [[ ! -d $1 ]]; then git clone --quiet --no-hardlinks "$root" "$1"; fi
  git -C "$1" fetch --quiet "$root" HEAD
  git -C "$1" checkout --quiet --force --detach FETCH_HEAD
}

# Processor, cores and system of this machine.
machine()
{
  awk -F ': |"' -v cores="$(nproc)" '/^model name/ { model = $2 } /^PRETTY_NAME/ { system_name = $2 }
    END { print model ", " cores " cores, " system_name }' /proc/cpuinfo /etc/os-release
}

# prove <name> command...: runs the command; keeps its words in build/proof/<name>.log, and adds a line to
# build/proof/stages.tsv: name, commit at the begin, begin, end, result, the sentence of the log that counts with
# the number of skipped tests, machine.
prove()
{
  local -r name=$1 proof=$root/build/proof
  shift
  mkdir -p "$proof"
  local commit begin count skipped status=0 result=passed
  commit=$(commit_built)
  begin=$(now)
  "$@" 2>&1 | tee "$proof/$name.log" || status=$?
  if ((status != 0)); then result=failed; fi
  count=$(grep -E 'tests passed|nothing found|to the same bits|^The first picture was drawn' "$proof/$name.log" | tail -n 1 || true)
  skipped=$(grep -c '\*\*\*Skipped' "$proof/$name.log" || true)
  if ((skipped > 0)); then count+="; $skipped skipped"; fi
  printf '%s\t%s\t%s\t%s\t%s\t%s\t%s\n' "$name" "$commit" "$begin" "$(now)" "$result" "$count" "$(machine)" \
    >>"$proof/stages.tsv"
  return "$status"
}

# stage <name> "Description" command...: a proved step. One that passed is not repeated on the same commit
# without changed files.
stage()
{
  local -r name=$1 title=$2 stages_log=$root/build/proof/stages.tsv
  shift 2
  local commit
  commit=$(commit_built)
  if [[ $commit != *-dirty && -f $stages_log ]] &&
    awk -F '\t' -v name="$name" -v commit="$commit" \
      '$1 == name && $2 == commit && $5 == "passed" { found = 1 } END { exit !found }' "$stages_log"; then
    echo "==> $title: passed before on $commit"
    return
  fi
  prove "$name" step "$title" "$@"
}

# Number of parallel compilers: one per core, and 1.5 GB of free memory for each, because a file
# that includes VTK or Qt needs nearly that much.
jobs_for_building()
{
  local cores free_kB jobs
  cores=$(nproc)
  free_kB=$(awk '/^MemAvailable:/ { print $2 }' /proc/meminfo)
  # A container may be limited to less memory than the machine has.
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

# Git refuses to read a folder of another owner. The build only needs the name of the commit, so the
# project's folder is declared safe for this run only.
trust_own_folder()
{
  local -r count=${GIT_CONFIG_COUNT:-0}
  export GIT_CONFIG_COUNT=$((count + 1))
  export "GIT_CONFIG_KEY_$count=safe.directory" "GIT_CONFIG_VALUE_$count=$root"
}

# configuration_stamp <preset> [options]: what ninja does not watch of a configured build folder: path, words for
# CMake, presets, commit.
configuration_stamp()
{
  echo "$root" "$@"
  cksum <"$root/CMakePresets.json"
  git -C "$root" describe --always --dirty --abbrev=12 2>/dev/null || echo "no commit"
}

# configure <preset> [options]: runs CMake if anything changed that ninja would not notice.
configure()
{
  local -r build_folder=$root/build/$1
  local -r build_log=$root/build/$1-configure.log stamp=$build_folder/configured-for
  if [[ -f $build_folder/build.ninja && -f $stamp && $(configuration_stamp "$@") == "$(<"$stamp")" ]]; then
    return
  fi
  mkdir -p "$build_folder" 2>/dev/null || true
  if [[ ! -w $build_folder ]]; then
    fail "$build_folder cannot be written. Run this as a user who may write there, or copy the project to a place of your own."
  fi
  # A build folder copied from another path is configured for that path.
  local -r cache=$build_folder/CMakeCache.txt
  if [[ -f $cache ]] && ! grep -qxF "CMAKE_HOME_DIRECTORY:INTERNAL=$root" "$cache"; then
    rm -rf "${build_folder:?}"
    mkdir -p "$build_folder"
  fi
  rm -f "$stamp"
  (cd "$root" && cmake --preset "$@") >"$build_log" 2>&1 || {
    tail -n 25 "$build_log" >&2
    fail "CMake could not configure preset $1; its last lines are above, all of them in $build_log."
  }
  configuration_stamp "$@" >"$stamp"
}

# build <preset> [target]: builds everything, or a target.
build()
{
  local -r preset=$1 target=${2:-all}
  (cd "$root" && cmake --build --preset "$preset" --parallel "$(jobs_for_building)" --target "$target") ||
    fail "Preset $preset does not build; the compiler's words are above. If it says 'Killed', memory ran out: close programs and run this again, it goes on where it stopped."
}
