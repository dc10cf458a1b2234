#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Breaks metrics and claims one place at a time in a copy of the tree, and tells which breaks no test notices.

Usage: tests/mutants/mutants.py [--build FOLDER] [NUMBER ...]

Without numbers all of them are tried. FOLDER keeps the copy and what is compiled for the next call (default: build/mutants). A mutant is
a file, a part of it that stands there once, and what it is replaced with; one whose part is not there any more is an error. The exit code
is 1 if a mutant survives.
"""
import argparse
import pathlib
import shutil
import subprocess
import sys

CLAIMS = "analysis/claims/"
MUTANTS = [
    (CLAIMS + "finite.h", "if (!std::isfinite(value)) throw", "if (std::isinf(value)) throw"),
    (CLAIMS + "finite.h", "std::isnan(a) || std::isnan(b) ?", "std::isnan(a) ?"),
    (CLAIMS + "finite.h", "half * (1 + 1e-9)", "2 * half"),
    (CLAIMS + "finite.h", "return -larger(-a, -b);", "return -larger(a, b);"),
    (CLAIMS + "results.cpp", "sum[i] += sign * values[i];", "sum[i] += values[i];"),
    (CLAIMS + "results.cpp", "std::abs(value - sum.front())", "std::abs(value - sum.back())"),
    (CLAIMS + "results.cpp", "if (ledger_.rows.size() < 2)", "if (ledger_.rows.size() < 1)"),
    (CLAIMS + "results.cpp", "row + 2, name", "row + 1, name"),
    (CLAIMS + "ledger_metrics.cpp", "run.last(column) / before", "before / run.last(column)"),
    (CLAIMS + "ledger_metrics.cpp", '{"latent_heat_J", 1}', '{"latent_heat_J", -1}'),
    (CLAIMS + "ledger_metrics.cpp", '{"water_evaporated_kg", 1}', '{"water_evaporated_kg", 0.5}'),
    (CLAIMS + "ledger_metrics.cpp", "{impulse.c_str(), -1}", "{impulse.c_str(), 1}"),
    (CLAIMS + "ledger_metrics.cpp", 'smallest("temperature_min_C")', 'largest("temperature_min_C")'),
    (CLAIMS + "ledger_metrics.cpp", 'largest("height_m")', 'last("height_m")'),
    (CLAIMS + "ledger_metrics.cpp", "larger(std::abs(largest_of(values)), std::abs(smallest_of(values)))", "largest_of(values)"),
    (CLAIMS + "frame_metrics.cpp", "temperature_of(run, frame, a) - temperature_of(run, frame, b)",
     "temperature_of(run, frame, b) - temperature_of(run, frame, a)"),
    (CLAIMS + "frame_metrics.cpp", ">= *at.temperature_C", "> *at.temperature_C"),
    (CLAIMS + "frame_metrics.cpp", "*at.dried_share - 0.5", "*at.dried_share"),
    (CLAIMS + "frame_metrics.cpp", "return 2 * radius_of_share(", "return radius_of_share("),
    (CLAIMS + "frame_metrics.cpp", "-2 * xz / xx", "2 * xz / xx"),
    (CLAIMS + "frame_metrics.cpp", "if (place[2] > ring[1])", "if (place[2] < ring[1])"),
    (CLAIMS + "frame_metrics.cpp", "all > 0 && ", ""),
    (CLAIMS + "neck_metrics.cpp", "std::sqrt(thinnest / part / std::numbers::pi)", "thinnest / part / std::numbers::pi"),
    (CLAIMS + "neck_metrics.cpp", "across += y0 * z - z0 * y;", "across += y0 * z + z0 * y;"),
    (CLAIMS + "neck_metrics.cpp", "along == 0 && across == 0 ? std::nan(\"\") :", ""),
    (CLAIMS + "region_metrics.cpp", "return (time_of_share(times, shares, 0.9) - first) / first;",
     "return time_of_share(times, shares, 0.9) - first;"),
    (CLAIMS + "region_metrics.cpp", "peak >= curve_.points.back().at ? peak : theta", "theta"),
    (CLAIMS + "region_metrics.cpp", "if (!(at_start_ > 0))", "if (at_start_ < 0)"),
    (CLAIMS + "region_metrics.cpp", "< k_broken", "< 2"),
    (CLAIMS + "region_metrics.cpp", "std::max(reach[window[row]], at.radius_m.value_or(0))", "reach[window[row]]"),
    (CLAIMS + "ledger_metrics.cpp", "(run.last(\"height_m\") - pressed) / lost", "(run.last(\"height_m\") - pressed) / before"),
    (CLAIMS + "body_metrics.cpp", "k_reach = 1.5", "k_reach = 2.5"),
    (CLAIMS + "body_metrics.cpp", "(after - frames.turn() * before).norm()", "(after - before).norm()"),
    (CLAIMS + "metric.cpp", "point[axis] > (*at.high_m)[axis]", "point[axis] > (*at.high_m)[0]"),
    (CLAIMS + "surface_metrics.cpp", "!p.closed", "p.closed"),
    (CLAIMS + "surface_metrics.cpp", "if (&now == &first)", "if (false)"),
    (CLAIMS + "surface_metrics.cpp", "return largest_shares(fracture, at)[1];", "return largest_shares(fracture, at)[0];"),
    (CLAIMS + "surface_metrics.cpp", "all > 0 ? crack_area(fracture, at) / all", "all > 0 ? crack_area(fracture, at)"),
    (CLAIMS + "fracture.cpp", "frame.pieces.empty() ||", ""),
    (CLAIMS + "fracture.cpp", "json.is_null() ? std::nan(\"\") : json.get<double>()", "json.get<double>()"),
    (CLAIMS + "claim.cpp", "<= *claim.tolerance;", "< *claim.tolerance;"),
    (CLAIMS + "claim.cpp", "measured <= *claim.at_most", "measured < *claim.at_most"),
    (CLAIMS + "claim.cpp", "v.measured > claim.factor * other.value", "v.measured > other.value"),
    (CLAIMS + "claim.cpp", "if (v.problem.empty()) v.problem = other.problem;", ""),
    (CLAIMS + "claim.cpp", "std::isfinite(before) && ", ""),
    (CLAIMS + "claim.cpp", "v.problem.empty() && is_within_bounds", "is_within_bounds"),
    (CLAIMS + "metric.cpp", "std::isfinite(number) ? \"\"", "!std::isnan(number) ? \"\""),
    (CLAIMS + "blessing.cpp", "if (!std::isfinite(*blessing.expected[i]))", "if (false)"),
]


def run(*words):
    return subprocess.run(words, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)


def copy_tree(root, copy):
    """Copies what differs, so that a second call compiles only that."""
    for name in run("git", "-C", str(root), "ls-files").stdout.splitlines():
        source, target = root / name, copy / name
        if not source.is_file() or (target.is_file() and target.read_bytes() == source.read_bytes()):
            continue
        target.parent.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(source, target)
        shutil.copymode(source, target)


def built(build):
    return run("ninja", "-C", str(build), "claims_tests")


def tested(build):
    return run(str(build / "tests/claims_tests"), "--gtest_brief=1")


def prepare(root, folder):
    """A build that is not optimised, with the files of claims by themselves: a mutant costs the compilation of what includes it."""
    copy, build = folder / "source", folder / "build"
    copy_tree(root, copy)
    with (copy / "CMakeLists.txt").open("a") as lists:
        lists.write("set_target_properties(bake_claims claims_tests PROPERTIES UNITY_BUILD OFF)\n")
    options = ["-DBAKE_TESTS=ON", "-DBAKE_FIGURES=OFF", "-DCMAKE_BUILD_TYPE=Debug", "-DCMAKE_CXX_FLAGS_DEBUG=-O0"]
    for done in (run("cmake", "-S", str(copy), "-B", str(build), "-G", "Ninja", *options), built(build), tested(build)):
        if done.returncode != 0:
            sys.exit(f"mutants: the tree as it is does not build or fails its tests:\n{done.stdout[-3000:]}")
    return copy, build


def survives(copy, build, mutant):
    name, part, other = mutant
    file = copy / name
    text = file.read_text()
    if text.count(part) != 1:
        sys.exit(f"{name}: found {text.count(part)} times {part!r}, allowed: once (tests/mutants/mutants.py)")
    file.write_text(text.replace(part, other))
    try:
        made = built(build)
        if made.returncode != 0:
            sys.exit(f"{name}: {other!r} does not compile:\n{made.stdout[-2000:]}")
        return tested(build).returncode == 0
    finally:
        file.write_text(text)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    root = pathlib.Path(__file__).resolve().parents[2]
    parser.add_argument("--build", type=pathlib.Path, default=root / "build/mutants")
    parser.add_argument("numbers", nargs="*", type=int)
    arguments = parser.parse_args()
    wrong = [n for n in arguments.numbers if not 1 <= n <= len(MUTANTS)]
    if wrong:
        parser.error(f"found mutant {wrong[0]}, allowed: 1 to {len(MUTANTS)}")
    chosen = arguments.numbers or range(1, len(MUTANTS) + 1)
    copy, build = prepare(root, arguments.build.resolve())
    surviving = 0
    for number in chosen:
        lives = survives(copy, build, MUTANTS[number - 1])
        surviving += lives
        name, part, other = MUTANTS[number - 1]
        print(f"{number:3} {'SURVIVES' if lives else 'noticed '} {name}: {part!r} -> {other!r}", flush=True)
    print(f"{len(chosen) - surviving} of {len(chosen)} mutants are noticed")
    return 1 if surviving else 0


if __name__ == "__main__":
    sys.exit(main())
