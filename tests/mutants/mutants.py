#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Breaks metrics, claims and meshing one place at a time in a copy of the tree, and tells which breaks no test notices.

Usage: tests/mutants/mutants.py [--build FOLDER] [WHICH ...]

WHICH is a number or the beginning of a file's path, as meshing/ or meshing/tets/manifold; without it all of them are tried. FOLDER keeps
the copy and what is compiled for the next call (default: build/mutants). A mutant is a file, a part of it that stands there once, and what
it is replaced with; one whose part is not there any more is an error. The last lines name those that survive, and the exit code is 1 then.
"""
import argparse
import os
import pathlib
import shutil
import subprocess
import sys

CLAIMS, SOLID, TETS, SKIN, FRACTURE = "analysis/claims/", "meshing/solid/", "meshing/tets/", "meshing/skin/", "meshing/fracture/"

# By a mutant's folder: what is built, and the tests that are asked.
ROOMS = {CLAIMS: ("claims_tests", "^unit/claims/"), "meshing/": ("meshing_tests", "^unit/meshing/")}

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
    (CLAIMS + "frame_metrics.cpp", "held(frame, run.frame(frame)) / before", "held(frame, run.frame(frame))"),
    (CLAIMS + "ledger_metrics.cpp", "frame > 0 ? frame - 1 : 0", "frame"),
    (CLAIMS + "ledger_metrics.cpp", "* run.at(\"surface_m2\", frame)", "* run.at(\"surface_m2\", before)"),
    (CLAIMS + "frame_metrics.cpp", "return 2 * radius_of_share(", "return radius_of_share("),
    (CLAIMS + "frame_metrics.cpp", "return (k_to - k_from) * spread.gain() /", "return spread.gain() /"),
    (CLAIMS + "frame_metrics.cpp", "const double half = largest_of(rates) / 2;", "const double half = largest_of(rates);"),
    (CLAIMS + "frame_metrics.cpp", "spread.diameters.back() / largest_of(spread.diameters)", "spread.diameters.back()"),
    (CLAIMS + "volume_share.h", "* (share - shares[i - 1]) /", "* share /"),
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
    (SOLID + "polygon_file.cpp", "v >= static_cast<std::int64_t>(soup.points.size())", "v > static_cast<std::int64_t>(soup.points.size())"),
    (SOLID + "polygon_file.cpp", '{"uchar", taken<std::uint8_t>}', '{"uchar", taken<std::int8_t>}'),
    (SOLID + "polygon_file.cpp", "v > 0 ? v - 1 : count + v", "v > 0 ? v - 1 : count + v - 1"),
    (SOLID + "cleaning.cpp", "{2e-6, 2e-5}", "{2e-5, 2e-4}"),
    (SOLID + "cleaning.cpp", "if (turn(a, b, x) >= 0 && turn(b, c, x) >= 0 && turn(c, a, x) >= 0) return false;", ""),
    (SOLID + "cleaning.cpp", "k_flat * longest * longest", "k_flat * longest"),
    (SOLID + "triangle_file.cpp", "k_doubtful_extent_m = 20;", "k_doubtful_extent_m = 200;"),
    (SOLID + "triangle_file.cpp", "if (mended_.turned)", "if (false)"),
    (SOLID + "triangle_file.cpp", "x = {x[0], -x[2], x[1]};", "x = {x[0], x[2], x[1]};"),
    (SOLID + "triangle_mesh.cpp", "< least) return true", "> least) return true"),
    (SOLID + "triangle_solid.cpp", "? -unit(away) : unit(away)", "? unit(away) : unit(away)"),
    (TETS + "tet_mesh.cpp", "n2 = cross(e, d - a)", "n2 = cross(d - a, e)"),
    (TETS + "tet_mesh.cpp", "if (f + 2 != last && same(f[0], f[2]))", "if (false)"),
    (TETS + "tet_mesh.cpp", "j - i != 2 || sum != 0", "j - i != 2 && sum != 0"),
    (TETS + "delaunay.cpp", "{t[1], t[0], t[3], t[2]}", "{t[1], t[0], t[2], t[3]}"),
    (TETS + "effort.cpp", "effort.bytes > memory || effort.seconds", "effort.bytes > memory && effort.seconds"),
    (TETS + "even_volumes.cpp", "(1.0 / 24) * n", "(1.0 / 6) * n"),
    (TETS + "even_volumes.cpp", "k_least_share = 0.5;", "k_least_share = 0.05;"),
    (TETS + "lattice_mesher.cpp", "if (distance >= 0.5 * d) return;", "if (distance >= 0) return;"),
    (TETS + "lattice_mesher.cpp", "even_volumes(best, 0.5 * best_a", "even_volumes(best, best_a"),
    (TETS + "manifold.cpp", "volume(group) > volume(largest)", "group.size() > largest.size()"),
    (TETS + "manifold.cpp", "if (outer_[v]) keep_largest_group", "if (false) keep_largest_group"),
    (TETS + "manifold.cpp", "if (!has_inner) drop(group);", ""),
    (TETS + "surface_foot.cpp", "k_sure = 0.03;", "k_sure = 0.3;"),
    (TETS + "own_process.cpp", "bytes_in_use() + bytes", "std::max(bytes_in_use(), bytes)"),
    (SKIN + "skin.cpp", "1e-6 * edge_length_m, edge_length_m", "1e-3 * edge_length_m, edge_length_m"),
    (FRACTURE + "breaking.cpp", "beyond && beyond_[e] && broken_at_[e] < 0", "beyond && beyond_[e]"),
    (FRACTURE + "census.cpp", "sums.second - sums.crack.area_m2 * c * c.transpose()", "sums.second"),
    (FRACTURE + "census.cpp", "a.area_m2 > b.area_m2", "a.area_m2 < b.area_m2"),
    (FRACTURE + "cut.cpp", "repeat < 3", "repeat < 1"),
    (FRACTURE + "cut.cpp", "face_centre(t, side, b, a, d), centre(t, side, b), face_centre(t, side, b, a, c)",
     "face_centre(t, side, b, a, c), centre(t, side, b), face_centre(t, side, b, a, d)"),
    (FRACTURE + "cut.cpp", "? ab || (ac && bc) : ac || (ab && bc)", "? ab : ac"),
    (FRACTURE + "depth.cpp", "std::sqrt(boundary->tree.squared_distance(cgal(x)))", "boundary->tree.squared_distance(cgal(x))"),
    (FRACTURE + "fracture.cpp", "frames.back() >= run.count()", "frames.back() > run.count()"),
    (FRACTURE + "fracture.cpp", "depth(shape_.points[n])", "depth(points_[n])"),
    (FRACTURE + "material_shape.cpp", "size == 2 ? 0.2 : 0.1", "size == 2 ? 0.02 : 0.01"),
    (FRACTURE + "positions.cpp", "(svd.matrixU() * svd.matrixV().transpose()).determinant()", "1"),
    (FRACTURE + "positions.cpp", "last = std::max(last, frame_of_break(topology, broken_at, node.vertices[i], node.vertices[j]))",
     "last = frame_of_break(topology, broken_at, node.vertices[i], node.vertices[j])"),
    (FRACTURE + "run_frames.cpp", "0.01 * dx_m_", "0.1 * dx_m_"),
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


def room_of(number):
    return next(room for room in ROOMS if MUTANTS[number - 1][0].startswith(room))


def built(build, room):
    return run("ninja", "-C", str(build), ROOMS[room][0])


def tested(build, room):
    """By ctest, which gives every random test the same cases each time and ends those that a mutant keeps from ending."""
    return run("ctest", "--test-dir", str(build), "-R", ROOMS[room][1], "-j", str(os.cpu_count()), "--timeout", "120", "--stop-on-failure",
               "--no-tests=error", "--output-on-failure")


def prepare(root, folder, rooms):
    """A build that is hardly optimised, with each file of a room by itself: a mutant costs the compilation of what includes it."""
    copy, build = folder / "source", folder / "build"
    copy_tree(root, copy)
    with (copy / "CMakeLists.txt").open("a") as lists:
        lists.write("set_target_properties(bake_claims claims_tests PROPERTIES UNITY_BUILD OFF)\n")
        lists.write("target_compile_options(bake_meshing PRIVATE -O1)\n")
        for library in ("bake_claims", "bake_meshing"):  # what a mutant no longer uses is no error
            lists.write(f"target_compile_options({library} PRIVATE -w)\n")
    options = ["-DBAKE_TESTS=ON", "-DCMAKE_BUILD_TYPE=Debug", "-DCMAKE_CXX_FLAGS_DEBUG=-O0 -DNDEBUG"]
    steps = [lambda: run("cmake", "-S", str(copy), "-B", str(build), "-G", "Ninja", *options)]
    for room in rooms:
        steps += [lambda: built(build, room), lambda: tested(build, room)]
    for step in steps:
        done = step()
        if done.returncode != 0:
            sys.exit(f"mutants: the tree as it is does not build or fails its tests:\n{done.stdout[-3000:]}")
    return copy, build


def survives(copy, build, number):
    name, part, other = MUTANTS[number - 1]
    file = copy / name
    text = file.read_text()
    if text.count(part) != 1:
        sys.exit(f"{name}: found {text.count(part)} times {part!r}, allowed: once (tests/mutants/mutants.py)")
    file.write_text(text.replace(part, other))
    try:
        made = built(build, room_of(number))
        if made.returncode != 0:
            sys.exit(f"{name}: {other!r} does not compile:\n{made.stdout[-2000:]}")
        return tested(build, room_of(number)).returncode == 0
    finally:
        file.write_text(text)


def chosen(words, parser):
    numbers = []
    for word in words:
        found = [n for n, (name, _, _) in enumerate(MUTANTS, 1) if word == str(n) or name.startswith(word)]
        if not found:
            parser.error(f"found {word}, allowed: 1 to {len(MUTANTS)}, or the beginning of a mutant's file, as meshing/")
        numbers += found
    return numbers or list(range(1, len(MUTANTS) + 1))


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    root = pathlib.Path(__file__).resolve().parents[2]
    parser.add_argument("--build", type=pathlib.Path, default=root / "build/mutants")
    parser.add_argument("which", nargs="*")
    arguments = parser.parse_args()
    numbers = chosen(arguments.which, parser)
    copy, build = prepare(root, arguments.build.resolve(), [room for room in ROOMS if any(room_of(n) == room for n in numbers)])
    surviving = []
    for n in numbers:
        name, part, other = MUTANTS[n - 1]
        lives = survives(copy, build, n)
        line = f"{n:3} {'SURVIVES' if lives else 'noticed '} {name}: {part!r} -> {other!r}"
        print(line, flush=True)
        surviving += [line] * lives
    print(f"{len(numbers) - len(surviving)} of {len(numbers)} mutants are noticed")
    if surviving:
        sys.exit("\n".join([f"{len(surviving)} SURVIVE: no test fails when these places are broken", *surviving]))


if __name__ == "__main__":
    main()
