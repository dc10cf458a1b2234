#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# What the findings share; each sources this file. It gives a temporary folder, $folder, which is removed at the end, and functions that
# install packages into it and compare what is seen with what the finding states.
# Exit codes: 0 the finding holds, 1 the behaviour is another one by now, 2 it could not be tried.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"

cannot_try() { echo "could not be tried: $*" >&2; exit 2; }

# Packages of the npm registry as name@version. Their install scripts do not run.
npm_packages() {
  echo '{"private": true}' >package.json
  npm install --no-audit --no-fund --ignore-scripts --legacy-peer-deps --silent "$@" >npm.log 2>&1 || cannot_try "npm cannot install $*"
}

# Debian packages as name=version, and those they need that the machine does not have; unpacked here, the machine stays as it is.
# Their Python packages are found by "$python".
debian_packages() {
  local needed package
  mkdir -p packages root
  needed=$(apt-get install --simulate --no-install-recommends "${@}" 2>apt.log | awk '/^Inst/ {print $2}') ||
    cannot_try "apt knows no way to install $*"
  for package in "$@"; do needed=$(grep -vxF "${package%%=*}" <<<"$needed" || true); done
  # shellcheck disable=SC2086  # one word a package
  (cd packages && apt-get download "$@" $needed) >apt.log 2>&1 || cannot_try "apt cannot download $*"
  for package in packages/*.deb; do dpkg -x "$package" root; done
  local libraries="$folder/root/usr/lib" of_machine
  mkdir -p "$libraries"
  of_machine=$(cd "$libraries" && echo ./*-linux-gnu*)
  export LD_LIBRARY_PATH="$libraries/$of_machine"
  LD_LIBRARY_PATH+=":$libraries/$of_machine/blas:$libraries/$of_machine/lapack:$folder/root/lib/$of_machine:$libraries"
  export PATH="$folder/root/usr/bin:$PATH" PYTHONPATH="$folder/root/usr/lib/python3/dist-packages"
  python=/usr/bin/python3  # Debian's own, which the packages are made for
  [[ -x $python ]] || python=$folder/root/usr/bin/python3
}

# Compiles a program that uses the unpacked packages: compile <source> [libraries]
compile() {
  c++ -std=c++17 -O1 -I root/usr/include -I root/usr/include/eigen3 "$1" -o program -L "${LD_LIBRARY_PATH%%:*}" "${@:2}" 2>compile.log ||
    cannot_try "$1 does not compile: $(grep -m 1 error compile.log)"
}

# Runs a command; what it prints becomes $seen, one line.
look_at() { seen=$("$@" 2>messages | tr '\n' ' ' | sed 's/ *$//') || seen="failed: $(grep -m 1 -i error messages || tail -n 1 messages)"; }

# conclude <what must have been seen> <the finding in one sentence>
conclude() {
  if [[ $seen == "$1" ]]; then
    echo "holds: $2 ($seen)"
  else
    echo "no longer true: $2; seen is now: $seen; it was: $1"
    exit 1
  fi
}
