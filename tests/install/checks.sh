# SPDX-License-Identifier: MIT
# What the tests in this folder share: a sandbox that goes at the end, and conditions of which those that fail are told and counted, with
# the variables that `shown` names.
sandbox=$(mktemp -d)
trap 'rm -rf "$sandbox"' EXIT
failures=0

expect() { # <what holds> <condition...>
  local what=$1 name
  shift
  if "$@"; then return; fi
  failures=$((failures + 1))
  printf 'FAILED: %s\n' "$what"
  for name in "${shown[@]}"; do printf '  %s: %s\n' "$name" "${!name}"; done
}
says() { [[ $output == *"$1"* ]]; }
finish() {
  echo "$failures failed"
  exit $((failures > 0))
}
