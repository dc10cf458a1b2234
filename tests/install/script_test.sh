#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Tests the script ./bake by itself: a copy of it runs in an empty folder where apt, CMake, Ninja and the compiler are stand-ins
# that only record how they were called. Usage: script_test.sh <source folder>
set -euo pipefail
unset CC CXX

source_folder=$1
source "$(dirname -- "${BASH_SOURCE[0]}")/checks.sh"
shown=(status output calls)
clone="$sandbox/a clone"
tools=$sandbox/tools

stand_in() { # <name> <what it does>
  printf '#!/bin/bash\necho "$(basename "$0") $*" >>"%s/calls"\n%s\n' "$sandbox" "$2" >"$tools/$1"
  chmod +x "$tools/$1"
}

# A new clone on a Debian with every package.
fresh_clone() {
  rm -rf "$clone" "$tools"
  mkdir -p "$clone" "$tools"
  cp "$source_folder/bake" "$clone/"
  cp -r "$source_folder/packages" "$clone/"
  local tool
  for tool in bash env basename dirname readlink cat sed grep cut tr tail tee rm mkdir mktemp touch flock nproc id chmod; do
    ln -s "$(command -v "$tool")" "$tools/$tool"
  done
  stand_in dpkg-query 'shift 3; printf "installed %s\n" "$@"'
  stand_in apt-get 'true'
  stand_in g++ 'echo 12'
  stand_in sudo '"$@"'
  stand_in cmake 'mkdir -p build/$2; touch build/$2/build.ninja
echo "CMAKE_HOME_DIRECTORY:INTERNAL=$PWD" >build/$2/CMakeCache.txt
for word in "$@"; do case $word in -DBAKE_*=ON) word=${word#-D}; echo "${word%=ON}:BOOL=ON" >>build/$2/CMakeCache.txt ;; esac; done'
  stand_in ninja 'for name in bake bake-mesh bake-render bake-count bake_bench bake-same-code; do
printf "#!/bin/bash\nprintf \"<%%s>\" \"\${0##*/}\" \"\$@\"; exit 7\n" >"$2/$name"; chmod +x "$2/$name"; done'
  stand_in ctest 'echo "100% tests passed"'
  : >"$sandbox/calls"
}

# Runs the script; sets status, output (both streams) and calls (of the stand-ins).
run() {
  : >"$sandbox/calls"
  status=0
  output=$(cd "$sandbox" && PATH=$tools "$clone/bake" "$@" 2>&1) || status=$?
  calls=$(<"$sandbox/calls")
}

exits_with() { [[ $status == "$1" ]]; }
called() { [[ $calls == *"$1"* ]]; }
not() { ! "$@"; }

fresh_clone
run run bread --set 'a=[1, 2]' ''
expect "the program gets the arguments unchanged" says '<bake><run><bread><--set><a=[1, 2]><>'
expect "the program's exit code is the script's" exits_with 7
expect "only the program is built" called "bake_program"
expect "nothing is installed when nothing is missing" not called "apt-get"
expect "tests are not configured for a run" called "-DBAKE_TESTS=OFF"
expect "figures are not configured for a run" called "-DBAKE_FIGURES=OFF"
expect "nothing of figures is built for a run" not called "bake_mesh"
run run bread
expect "the second time does not configure" not called "cmake"
expect "the second time does not look at packages" not called "dpkg-query"
expect "the second time shows nothing of its own" [ "$output" = "<bake><run><bread>" ]
run --help
expect "options alone go to the program" says '<bake><--help>'
run figure 15 --quality draft
expect "the program makes figures" says '<bake><figure><15><--quality><draft>'
expect "figures need their packages" called "gnuplot-nox"
expect "figures need the other programs" called "-DBAKE_FIGURES=ON"
expect "figures build all three programs" called "bake_program bake_mesh bake_render"
run mesh tets 'a b.toml'
expect "mesh is a program of its own" says '<bake-mesh><tets><a b.toml>'
run render --help
expect "render is a program of its own" says '<bake-render><--help>'
stand_in python3 'printf "<%s>" "${1##*/}" "${@:2}"; exit 7'
run paper --out 'a b'
expect "the article is a script of Python that gets the arguments" says '<make_article.py><--out><a b>'
expect "the article's exit code is the script's" exits_with 7
expect "the article needs its packages" called "texlive-latex-recommended"
expect "the article needs nothing else" not called "cmake"
expect "nothing is built for the article" not called "ninja"
run paper
expect "the second article does not look at packages" not called "dpkg-query"
run report
expect "the second time does not configure for figures either" not called "cmake"
run bench --fast
expect "benchmarks get their arguments" says '<bake_bench><--fast>'
run count
expect "counting checks unless told otherwise" says '<bake-count><check>'
expect "counting has a build of its own" called "--preset reference"
expect "counting needs valgrind" called "valgrind"
run count bless --why 'a reason'
expect "count gets its arguments" says '<bake-count><bless><--why><a reason>'
mkdir -p "$clone/solver/identity"
printf '#!/bin/bash\nprintf "<%%s>" "$CXX" "${1##*/}" "${@:2}"; exit 1\n' >"$clone/solver/identity/restamp.sh"
chmod +x "$clone/solver/identity/restamp.sh"
run restamp 'a commit'
expect "stamping anew is a script that gets compiler, program and commit" says "<$tools/g++><bake-same-code><a commit>"
expect "stamping anew builds what compares" called "bake_same_code"
expect "stamping anew has its own exit code" exits_with 1
run run bread
expect "a run after figures is lean again" not called "bake_mesh"
run test -R Transfer
expect "tests are built with everything" called "-DBAKE_TESTS=ON -DBAKE_FIGURES=ON"
expect "arguments of test go to ctest" called "--parallel 2 -R Transfer"
expect "passing tests are a success" exits_with 0
stand_in ctest 'exit 8'
run test
expect "failing tests are exit 1" exits_with 1
echo libnew-dev >>"$clone/packages/run.txt"
run run bread
expect "a changed list is checked again" called "dpkg-query"
stand_in g++-13 'echo 13'
rm "$tools/g++"
run run bread
expect "another compiler configures again" called "g++-13"

fresh_clone
stand_in dpkg-query 'true'
run figure --help
expect "help installs nothing" not called "apt-get"
expect "help of figures asks for no package of figures" not says "gnuplot-nox"
stand_in python3 'echo "the help"'
run paper --help
expect "help of the article installs nothing" not called "apt-get"
expect "help of the article asks for no package" not called "dpkg-query"
expect "help of the article is its script's" says "the help"
run paper --no-install
expect "an article without LaTeX and --no-install is exit 2" exits_with 2
expect "the packages of the article are named, and no others" says "missing packages: python3 python3-tomli texlive-latex-recommended texlive-fonts-recommended"
run paper
expect "packages of the article are installed" called "install --yes --no-install-recommends python3"
rm "$tools/python3"
run paper --help
expect "help of the article without Python names what is missing" says "missing packages: python3"
run run bread --no-install
expect "missing packages and --no-install are exit 2" exits_with 2
expect "missing packages are named" says "missing packages: cmake ninja-build libeigen3-dev"
expect "--no-install installs nothing" not called "apt-get"
expect "a run does not ask for test packages" not says "libgtest-dev"
run --no-install test
expect "tests ask for test packages" says "libgtest-dev"
expect "tests ask for the packages of figures" says "gnuplot-nox"
rm "$tools/g++"
run run bread --no-install
expect "a missing compiler is named" says "g++"
stand_in g++ 'echo 11'
run run bread --no-install
expect "an old compiler counts as missing" says "g++"
run run bread
expect "missing packages are installed" called "install --yes --no-install-recommends cmake"
expect "without a new enough compiler there is no build" exits_with 2
stand_in apt-get 'if [[ $* == *install* ]]; then echo "no such package"; exit 100; fi'
run run bread
expect "a failed installation is exit 3" exits_with 3
expect "a failed installation shows its end" says "no such package"

fresh_clone
rm "$tools/apt-get" "$tools/dpkg-query"
run run bread
expect "another system with the tools builds all the same" exits_with 7
run paper
expect "another system without LaTeX has no article and is told why" says "pdflatex or python3 is missing"
rm "$tools/ninja"
run run bread
expect "another system without a tool is exit 2" exits_with 2
expect "another system is told what is needed" says "no apt-get"

fresh_clone
stand_in ninja 'echo "error: expected a semicolon"; exit 1'
run run bread
expect "a failed build is exit 3" exits_with 3
expect "a failed build shows its end" says "expected a semicolon"
run run bread
expect "after a failed build the packages are checked again" called "dpkg-query"

fresh_clone
run run bread
mv "$clone" "$sandbox/moved"
clone=$sandbox/moved
run run bread
expect "a moved clone configures again" called "cmake"

# A folder that may not be written: for root only one that is mounted so, in a mount namespace of its own.
fresh_clone
run run bread
rm "$clone/build/release/bake-mesh"
read_only() {
  if (($(id -u) != 0)); then
    chmod a-w "$clone" "$clone/build" "$clone/build/release"
    run "$@"
    chmod u+w "$clone" "$clone/build" "$clone/build/release"
  else
    status=0
    # shellcheck disable=SC2016
    output=$(cd "$sandbox" && unshare --mount bash -c 'mount --bind "$0" "$0" && mount -o remount,ro,bind "$0" && PATH=$1 exec "$0/bake" "${@:2}"' \
      "$clone" "$tools" "$@" 2>&1) || status=$?
  fi
}
if (($(id -u) != 0)) || unshare --mount true 2>/dev/null; then
  read_only run bread
  expect "what is built in a folder that may not be written is run" [ "$output" = "<bake><run><bread>" ]
  read_only mesh tets
  expect "what is not built there is exit 3" exits_with 3
  expect "what is not built there is said" says "nothing is built"
fi

finish
