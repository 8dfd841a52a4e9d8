#!/usr/bin/env bash
# install-packages.sh PACKAGE...: install those that are missing, by apt-get; silent where none is.
set -euo pipefail

missing=()
for package in "$@"; do
  dpkg-query --show --showformat='${db:Status-Status}' "$package" 2>/dev/null |
    grep -qx installed || missing+=("$package")
done
[ "${#missing[@]}" -gt 0 ] || exit 0

become_root=()
if [ "$(id -u)" -ne 0 ]; then
  command -v sudo >/dev/null || { echo "Please install: ${missing[*]}" >&2; exit 1; }
  become_root=(sudo)
fi
echo "Installing ${missing[*]}"
# Another program may hold apt's locks, as after the start of a machine: wait up to 10 minutes.
apt_get=("${become_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -qq -o Dpkg::Use-Pty=0
  -o DPkg::Lock::Timeout=600)
for try in {1..60}; do
  output=$("${apt_get[@]}" update 2>&1) && break
  if [ "$try" -eq 60 ] || [[ $output != *"Could not get lock"* ]]; then
    echo "$output" >&2
    exit 1
  fi
  [ "$try" -gt 1 ] || echo "Waiting for another program that installs packages"
  sleep 10
done
"${apt_get[@]}" install --yes --no-install-recommends "${missing[@]}" >/dev/null
