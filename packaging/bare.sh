# SPDX-License-Identifier: BSD-3-Clause

# Sourced by scripts that try something in a bare Debian of any release, created in a folder. After
# packaging/steps.sh.
# shellcheck shell=bash

readonly releases=(bookworm trixie forky sid)

# prepare_bare <release>: checks that it can be made here, and installs what makes it.
prepare_bare()
{
  [[ " ${releases[*]} " == *" $1 "* ]] || fail "There is no release '$1' here; the releases: ${releases[*]}."
  ((EUID == 0)) || fail "A Debian in a folder needs root; run this with sudo."
  # shellcheck disable=SC2154  # of packaging/steps.sh
  "$root/packaging/install-dependencies" bare >/dev/null || fail "mmdebstrap is missing; install it with 'apt-get install mmdebstrap'."
}

# make_bare <release> <folder>: a system without anything that is not essential, and apt. It is thrown away
# after a crash of the machine, so that dpkg need not wait for the disk. Its apt takes package lists of the age that
# this machine's takes: those of a mirror that stands still expire, of sid after a week.
make_bare()
{
  local -a age
  mapfile -t age < <(apt-config dump Acquire::Check-Valid-Until)
  rm -rf --one-file-system "${2:?}"
  mmdebstrap --quiet --variant=minbase --dpkgopt=force-unsafe-io "${age[@]/#/--aptopt=}" "$1" "$2"
}

# enter_bare <folder>: devices and processes for the commands of in_bare, until leave_bare.
enter_bare()
{
  bare=$1
  mount --rbind --make-rslave /dev "$bare/dev"
  mount -t proc proc "$bare/proc"
  mount -t sysfs -o ro sysfs "$bare/sys"
  cp /etc/resolv.conf "$bare/etc/resolv.conf"
}

leave_bare()
{
  local place
  for place in sys proc dev; do
    if mountpoint -q "$bare/$place"; then umount --recursive --lazy "$bare/$place"; fi
  done
}

# in_bare command...: as root of the bare system, with nothing of this one's environment.
in_bare()
{
  env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LC_ALL=C.UTF-8 DEBIAN_FRONTEND=noninteractive chroot "$bare" "$@"
}
