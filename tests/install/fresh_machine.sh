#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Proves that a bare machine needs nothing but the clone: makes a minimal Debian or Ubuntu in a temporary folder, clones the
# last commit into it, and runs there what the README promises, timing each step. Takes some minutes.
#
#   sudo tests/install/fresh_machine.sh [suite]      e.g. bookworm, jammy, noble; default: the suite of this machine
#
# Needs root, debootstrap, git, and the suite among this machine's apt sources: its mirror and proxy are used.
set -euo pipefail

root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/../.." && pwd -P)
suite=${1:-$(. /etc/os-release && echo "$VERSION_CODENAME")}
machine=''
failures=0

die() { printf 'fresh_machine: %s\n' "$*" >&2; exit 2; }

# Mounts are made in the namespace of each step and end with it (see inside), so nothing but files is left to remove.
clean_up() { [[ -z $machine ]] || rm -rf --one-file-system "$machine" "$machine.log"; }
trap clean_up EXIT
trap 'exit 130' INT TERM

# Prints one field of this machine's apt sources for the suite, without repetitions.
apt_source() { apt-get indextargets --format "\$(RELEASE) \$($1)" 'Created-By: Packages' | sed -n "s/^$suite //p" | sort -u; }

make_machine() {
  local mirror components settings options=()
  mirror=$(apt_source REPO_URI | head -n 1)
  [[ -n $mirror ]] || die "no apt source of this machine has the suite $suite"
  components=$(apt_source COMPONENT | paste -sd,)
  if [[ $mirror == https:* ]]; then options+=(--include=ca-certificates); fi
  machine=$(mktemp -d "${TMPDIR:-/var/tmp}/fresh_machine.XXXXXX")
  debootstrap --variant=minbase --components="$components" "${options[@]}" "$suite" "$machine" "$mirror" >"$machine.log" 2>&1 ||
    { tail -n 20 "$machine.log" >&2; die "debootstrap failed"; }
  cp /etc/hosts "$machine/etc/hosts"
  settings=$(apt-config dump | grep -E '^Acquire::(https?(::[^:]+)?::Proxy|Check-Valid-Until) ' || true)
  printf '%s\n' "$settings" >"$machine/etc/apt/apt.conf.d/90host"
  git clone --quiet --no-hardlinks "$root" "$machine/root/bake"
}

# Runs a command in the clone on the fresh machine, with a fresh environment and no terminal.
inside() {
  # shellcheck disable=SC2016  # expanded by the inner shell
  unshare --mount --propagation private bash -c 'mount -t proc proc "$1/proc" && exec chroot "$@"' - "$machine" \
    /usr/bin/env -i HOME=/root PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin TERM=dumb \
    ${http_proxy:+http_proxy="$http_proxy"} ${https_proxy:+https_proxy="$https_proxy"} \
    bash -c 'cd /root/bake && exec "$@"' - "$@" </dev/null
}

# step <expected exit code> <command...>
step() {
  local expected=$1 status=0 start=$EPOCHREALTIME
  shift
  printf '\n$ %s\n' "$*"
  inside "$@" || status=$?
  local seconds
  seconds=$(awk "BEGIN {printf \"%.1f\", $EPOCHREALTIME - $start}")
  if [[ $status == "$expected" ]]; then
    printf -- '-- exit %s as expected, %s s\n' "$status" "$seconds"
  else
    printf -- '-- FAILED: exit %s instead of %s, %s s\n' "$status" "$expected" "$seconds"
    failures=$((failures + 1))
  fi
}

((EUID == 0)) || die "needs root (it makes a system of its own in a temporary folder and enters it)"
for tool in debootstrap git unshare awk; do command -v "$tool" >/dev/null || die "$tool is missing"; done

make_machine
step 2 ./bake run bread --no-install
step 0 ./bake run bread
step 0 ./bake version
step 0 ./bake test
printf '\n%s: %s steps failed\n' "$suite" "$failures"
exit $((failures > 0))
