# debian.sh: functions for scripts that make fresh systems of Debian, as root. Sourced by run.sh beside it, by
# Testing/Package/run.sh and by Testing/Wheel/systems.sh.
source_dir=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)

# usage SCRIPT: print its first comment, and end
usage()
{
  sed -n '2,/^set/s/^# \?//p' "$1" >&2
  exit 2
}

# require_debootstrap PACKAGE...: install it and other packages; set $mirror to that of this machine, if it is empty
require_debootstrap()
{
  [ "$(id -u)" -eq 0 ] || { echo "Only root can make systems" >&2; exit 2; }
  bash "$source_dir/CMake/install-packages.sh" debootstrap "$@"
  if [ -z "$mirror" ]; then
    mirror=$(apt-get indextargets --format '$(LABEL) $(REPO_URI)' | sed -n 's/^Debian //p' | head -n 1)
  fi
  : "${mirror:?This machine knows no mirror of Debian; name one by --mirror}"
}

# make_system SUITE ROOT PACKAGES: a minimal system with packages (separated by commas), a user tester without rights,
# and this machine's way to the network. The file ROOT/complete is made last.
make_system()
{
  rm -rf --one-file-system "$2"
  # All suites that debootstrap may not know yet are made as sid is.
  debootstrap --variant=minbase --include="ca-certificates${3:+,$3}" "$1" "$2" "$mirror" sid
  cp /etc/resolv.conf /etc/hosts "$2/etc"
  echo force-unsafe-io >"$2/etc/dpkg/dpkg.cfg.d/unsafe-io" # a system for tests need not survive a power failure
  apt-config dump Acquire >"$2/etc/apt/apt.conf.d/01host"
  chroot "$2" useradd --create-home --shell /bin/bash tester
  touch "$2/complete"
}

# within ROOT USER COMMAND [FOLDER PLACE]...: run in a system, with folders of this machine mounted at places there. All
# mounts end with the command.
within()
{
  local root=$1 user=$2 command=$3
  shift 3
  [ "$user" != root ] || command="export DEBIAN_FRONTEND=noninteractive; $command" # users have no variables of ours
  root=$root user=$user command=$command unshare --mount bash -c '
    set -e
    for system in proc sys dev; do mount --rbind "/$system" "$root/$system"; done
    while [ "$#" -gt 0 ]; do
      mount --bind "$1" "$root/$2"
      shift 2
    done
    exec chroot "$root" su - "$user" --command "$command"' within "$@"
}
