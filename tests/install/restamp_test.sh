#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Tests how machine code is compared and kept data stamped anew, in a small tree of its own. Usage: restamp_test.sh <source folder>
# <bake-same-code> <compiler>
set -euo pipefail
source_folder=$1 same_code=$2 compiler=$3
source "$(dirname -- "${BASH_SOURCE[0]}")/checks.sh"
shown=(status output)
cd "$sandbox"
was=0123456789abcdef now=fedcba9876543210 other=1111111111111111

write() { mkdir -p "$(dirname "$1")" && cat >"$1"; }
compiled() { # <folder>: its sources become its objects
  local file
  for file in "$1"/*.cpp "$1"/beside/*.cpp; do "$compiler" -std=c++20 -O2 -ffunction-sections -fdata-sections -I"$1" -c "$file" -o "${file%.cpp}.o"; done
}
keep() { # data of three solvers
  rm -rf data
  printf '{"by":{"solver":"%s"},"found":1}\n{"by":{"solver":"%s"},"found":2}\n' $was $other | write data/paper/accuracy/case.jsonl
  printf '{\n  "solver": "%s"\n}\n' $was | write data/results/bread/run.json
  printf '{"solver": "%s", "words": "%s"}\n' $other $was | write data/results/tear/run.json
  printf '{"solver": "%s"}\n' $was | write data/experiments/table01_timings/measured/bread.json
  printf '"solver": "%s"\n' $was | write data/paper/page.md
  rm -rf kept
  cp -r data kept
}
restamp() { # <objects>: sets status and output
  keep
  status=0
  output=$("$source_folder/solver/identity/restamp_if_same.sh" "$same_code" then "$1" $was $now data 2>&1) || status=$?
}
holds() { [[ $(<"data/$1") == "$2" ]]; }
is_refused() { [[ $status == 1 ]] && diff -r data kept && says "$1"; }

write then/law.h <<'E2'
#pragma once
namespace bake {
struct Law {
  virtual ~Law() = default;
  virtual double stress(double strain) const = 0;
};
inline double twice(double a) { return 2.5 * a; }
double curve(double a);
int read(const char* text);
}
E2
write then/beside/reader.cpp <<'E2'
#include "law.h"
namespace bake {
__attribute__((noipa)) double curve(double a) { return a * 4 + twice(a); }
int read(const char* text) { return text[0] - 1; }
}
E2
write then/elastic.cpp <<'E2'
#include "law.h"
#include <cmath>
#include <stdexcept>
namespace bake {
struct Elastic : Law {
  double stress(double strain) const override {
    if (strain < 0) throw std::runtime_error("strain below zero");
    return std::sin(twice(strain));
  }
};
Law* make_elastic() { return new Elastic; }
}
E2
write then/plastic.cpp <<'E2'
#include "law.h"
#include <cmath>
namespace bake {
namespace {
__attribute__((noinline)) double harden(double a, int kind) {
  switch (kind) {
    case 0: return std::exp(a);
    case 1: return std::cos(a + 1);
    case 2: return std::tan(a * 3);
    case 3: return std::log(a);
    case 4: return a;
    default: return 0;
  }
}
const char* const names[] = {"soft", "hard"};
}
const char* name_of(int i) { return names[i]; }
double both(double a, int kind) { return harden(a, kind) + std::sqrt(twice(a)); }
double read_curve(const char* text) { return curve(read(text)); }
}
E2
compiled then

# The same with other names, comments and places: one file instead of two, in another order; the curve is no longer in the room
# beside, where another reader is.
write moved/constitutive.h <<'E2'
// What a law is.
#pragma once
namespace bake {
struct Constitutive {
  virtual ~Constitutive() = default;
  virtual double stress_of(double strain) const = 0;
};
inline double doubled(double a) { return 2.5 * a; }
int parse(const char* text);
}
E2
write moved/beside/parser.cpp <<'E2'
#include "constitutive.h"
namespace bake {
int parse(const char* text) { return text[1] * 3; }
}
E2
write moved/all.cpp <<'E2'
#include "constitutive.h"
#include <cmath>
#include <stdexcept>
namespace bake {
namespace {
const char* const labels[] = {"soft", "hard"};
__attribute__((noinline)) double grow(double a, int kind) {
  switch (kind) {
    case 0: return std::exp(a);
    case 1: return std::cos(a + 1);
    case 2: return std::tan(a * 3);
    case 3: return std::log(a);
    case 4: return a;
    default: return 0;
  }
}
}
__attribute__((noipa)) double polygon(double a) { return a * 4 + doubled(a); }
double sum(double a, int kind) { return grow(a, kind) + std::sqrt(doubled(a)); }
struct Linear : Constitutive {
  double stress_of(double strain) const override {
    if (strain < 0) throw std::runtime_error("strain below zero");
    return std::sin(doubled(strain));
  }
};
double polygon_of(const char* text) { return polygon(parse(text)); }
const char* label_of(int i) { return labels[i]; }
Constitutive* make_linear() { return new Linear; }
}
E2
compiled moved
restamp moved
expect "other names, comments and places are accepted" [ "$status" == 0 ]
expect "lines of that solver are stamped, others are not" holds paper/accuracy/case.jsonl \
  '{"by":{"solver":"'$now'"},"found":1}'$'\n''{"by":{"solver":"'$other'"},"found":2}'
expect "a run is stamped, in its own form" holds results/bread/run.json $'{\n  "solver": "'$now$'"\n}'
expect "what is no identity is left alone" holds results/tear/run.json '{"solver": "'$other'", "words": "'$was'"}'
expect "measured times are stamped" holds experiments/table01_timings/measured/bread.json '{"solver": "'$now'"}'
expect "a page is left alone" holds paper/page.md '"solver": "'$was'"'
expect "what was stamped is told" says "3 files have the identity $now instead of $was"
expect "no other file is left" [ "$(find data -type f | wc -l)" == 5 ]

cp -r moved moved_badly
sed -i 's/a \* 4/a * 5/' moved_badly/all.cpp
compiled moved_badly
restamp moved_badly
expect "another operation in what has moved from beside is refused" is_refused "only in the second: 1 functions, 0 constants"$'\n'"  bake::polygon(double)"

change() { # <what is changed> <file> <sed expression> <what is said of it>
  rm -rf changed
  cp -r then changed
  sed -i "$3" "changed/$2"
  ! cmp -s "changed/$2" "then/$2"
  compiled changed
  restamp changed
  expect "$1 is refused" is_refused "$4"
}
change "another operation" plastic.cpp 's/a + 1/a - 1/' "changed: 1 functions, 0 constants"$'\n'"  bake::(anonymous namespace)::harden(double, int)"
change "another factor" law.h 's/2.5/2.25/' "bake::both(double, int)"
change "another function of the same kind" elastic.cpp 's/std::sin/std::cos/' "bake::Elastic::stress(double) const"
change "another string" plastic.cpp 's/soft/sore/' "constant bake::(anonymous namespace)::names"
change "another order of strings" plastic.cpp 's/"soft", "hard"/"hard", "soft"/' "changed: 0 functions, 1 constants"
change "another exception" elastic.cpp 's/runtime_error/logic_error/' "bake::Elastic::stress(double) const"
change "a function more" plastic.cpp '$s/}/double more(double a) { return a * 7; }\n}/' "only in the second: 1 functions, 0 constants"$'\n'"  bake::more(double)"
change "a function less" plastic.cpp '/name_of/d' "only in the first: 1 functions"
change "two laws for one" elastic.cpp 's/return new Elastic/return nullptr/' "bake::make_elastic()"
change "a call beside in place of another" plastic.cpp 's/curve(read(text))/curve(0)/' "bake::read_curve(char const*)"

restamp nowhere
expect "a folder that is not there is wrong use" [ "$status" == 2 ]
mkdir empty
restamp empty
expect "a folder without objects is wrong use" [ "$status" == 2 ]
expect "and changes nothing" diff -r data kept

# The whole command, on a small tree with git that builds its objects in the same places.
mkdir -p tiny/solver/run tiny/solver/scene tiny/solver/io tiny/results/bread
cp -r "$source_folder/solver/identity" tiny/solver/
cp "$source_folder/CMakePresets.json" tiny/
write tiny/CMakeLists.txt <<'E2'
cmake_minimum_required(VERSION 3.22)
project(tiny LANGUAGES CXX)
add_subdirectory(solver)
E2
write tiny/solver/CMakeLists.txt <<'E2'
file(STRINGS identity.txt identity)
file(WRITE ${CMAKE_BINARY_DIR}/generated/bake_commit.h "#define BAKE_SOLVER \"${identity}\"\n")
add_custom_target(bake_commit)
file(GLOB sources */*.cpp)
list(FILTER sources EXCLUDE REGEX identity)
add_library(tiny STATIC ${sources})
E2
printf 'build\nresults\n' >tiny/.gitignore
echo $was >tiny/solver/identity.txt
echo 'double law(double a) { return a * 3; }' >tiny/solver/run/law.cpp
echo 'int read() { return 1; }' >tiny/solver/scene/reader.cpp
echo 'const char* made_by() { return "this"; }' >tiny/solver/io/provenance.cpp
printf '{"solver": "%s"}\n' $was >tiny/results/bread/run.json
git -C tiny init --quiet
git -C tiny add .
git -C tiny -c user.name=test -c user.email=test@localhost commit --quiet --message first
whole() { # <arguments>: sets status and output
  status=0
  output=$(CXX=$compiler tiny/solver/identity/restamp.sh "$same_code" "$@" 2>&1) || status=$?
}
whole HEAD
expect "the same identity needs nothing" says "nothing to do"
echo $now >tiny/solver/identity.txt
echo 'double constitutive_law(double strain) { return strain * 3; }  // of Hooke' >tiny/solver/run/hooke.cpp
echo 'int read() { return 2; }' >tiny/solver/scene/reader.cpp
echo 'const char* made_by() { return "that"; }' >tiny/solver/io/provenance.cpp
rm tiny/solver/run/law.cpp
sed -i 's/3/4/' tiny/solver/run/hooke.cpp
whole HEAD
expect "another operation since that commit is refused" [ "$status" == 1 ]
expect "its function is named" says "constitutive_law(double)"
expect "its runs keep their identity" grep -q $was tiny/results/bread/run.json
sed -i 's/4/3/' tiny/solver/run/hooke.cpp
whole HEAD
expect "other names since that commit are accepted" [ "$status" == 0 ]
expect "its runs have the present identity" grep -q $now tiny/results/bread/run.json
expect "the work tree of that commit is gone" [ ! -e tiny/build/restamp/tree ]
whole
expect "no commit is wrong use" [ "$status" == 2 ]
whole no-such-commit
expect "what is no commit is wrong use" [ "$status" == 2 ]
expect "wrong use is told in one line" [ "$output" == "bake: restamp: found no-such-commit, allowed: a commit of this repository" ]

finish
