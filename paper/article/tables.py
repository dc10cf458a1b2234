# SPDX-License-Identifier: MIT
"""The tables of the article, and the numbers that are counted from several stored values. Each is a function without parameters of stored
files alone; article.tex names it as <<table: ...>> or <<derived: ...>>."""
import statistics

from stored import ROOT, Unknown, code, escaped, get, read, shown

FIGURES = "paper/figures"
QUALITIES = ("paper", "standard", "draft")
PER_FRAME = 24  # frames a second of table 1: see experiments/table01_timings


def rows(cells):
    return "\n".join(" & ".join(row) + r" \\" for row in cells)


# --- figures --------------------------------------------------------------------------------------------------------


def kept(name):
    """What is kept of an item at the finest quality; nothing if nothing is."""
    for quality in QUALITIES:
        path = f"{FIGURES}/{name}-{quality}/claims.json"
        if (ROOT / path).is_file():
            return read(path)
    return None


def items():
    """(item, what is kept of it) in the order of the paper; nothing is kept of table 1, which has a table of its own."""
    return [(item, kept(item["name"])) for item in read("paper/items.toml")["item"]]


def claims_of(item):
    return {(c["metric"], c["why"]) for c in read(f"experiments/{item['experiment']}/figure.toml").get("claim", [])}


def is_outdated(item, result):
    """Whether the item's claims are others now than those that were measured."""
    return {(c["metric"], c["why"]) for c in result["claims"]} != claims_of(item)


def number_of(item):
    return item["number"].replace("figure", "Fig.").replace("table", "Table").replace("experiment", "Exp.").replace(" ", "~")


def figures():
    cells = []
    for item, result in items():
        first = [number_of(item), escaped(item["shows"])]
        if item["name"] == "timings":
            cells.append(first + ["", "", r"\multicolumn{2}{l}{see table~\ref{timings}}"])
        elif result is None:
            cells.append(first + ["", "", r"\multicolumn{2}{l}{measured, but no record is kept}"])
        else:
            held = sum(c["holds"] for c in result["claims"])
            every = len(result["claims"])
            ratio = f"{held} of {every}"
            most = max((r["particles"] for r in result["runs"]), default=0)
            cells.append(first + [result["quality"] if most else "--", f"{most / 1000:.1f}" if most else "--",
                                  (ratio if held == every else rf"\textbf{{{ratio}}}") + (r"\,*" if is_outdated(item, result) else ""),
                                  stamp(result["provenance"])])
    return rows(cells)


def stamp(provenance):
    """Date and solver that something was measured with."""
    return f"{provenance['date'][:10]}, {code(provenance['program'].get('solver', provenance['program']['commit'])[:6])}"


def missed():
    cells = []
    for item, result in items():
        for claim in result["claims"] if result else []:
            if claim["holds"]:
                continue
            why = claim["why"].split(";")[0]
            measured = "none" if claim["measured"] is None else shown(claim["measured"]) + unit(claim["unit"])
            cells.append([number_of(item), code(claim["of"]), escaped(claim["metric"].replace("_", " ")), measured,
                          escaped(claim["condition"]), escaped(why)])
    return rows(cells)


def unit(text):
    return "" if text == "1" else r"\," + escaped(text)


def claims_made():
    return str(sum(len(result["claims"]) for _, result in items() if result))


def claims_held():
    return str(sum(c["holds"] for _, result in items() if result for c in result["claims"]))


def paper_items():
    """Figures and tables of the paper, without our experiments."""
    return [pair for pair in items() if not pair[0]["number"].startswith("experiment")]


def items_of_paper():
    return str(len(paper_items()))


def items_that_hold():
    return str(sum(result is not None and all(c["holds"] for c in result["claims"]) for _, result in paper_items()))


def items_that_miss():
    return str(sum(result is not None and not all(c["holds"] for c in result["claims"]) for _, result in paper_items()))


def items_without_a_record():
    return str(sum(result is None and item["name"] != "timings" for item, result in paper_items()))


# --- departures, orders, surface, stability -------------------------------------------------------------------------


def departures():
    cells = []
    for c in get("paper/departures.json", "consequences"):
        measured = rf"{escaped(c['measured'])} \emph{{(right: {escaped(c['expected'])})}}"
        cells.append([escaped(c["equation"]), escaped(c["printed"]), escaped(c["instead"]), measured, shown(c["published"]),
                      shown(c["standard"])])
    return rows(cells)


def orders():
    """The first order of every case."""
    cells, seen = [], set()
    for o in get("paper/orders.json", "orders"):
        if o["figure"] != "order" or o["case"] in seen:
            continue
        seen.add(o["case"])
        cells.append([escaped(o["case"].replace("_", " ")), escaped(o["quantity"]),
                      f"{o['refinements'][0]:g}--{o['refinements'][-1]:g} {escaped(o['refined'])}",
                      f"{shown(o['errors'][0], '.2g')} to {shown(o['errors'][-1], '.2g')}", f"{o['value']:.2f}",
                      f"{o['low']:g}--{o['high']:g}"])
    return rows(cells)


def orders_made():
    return str(len(get("paper/orders.json", "orders")))


def orders_held():
    return str(sum(o["holds"] for o in get("paper/orders.json", "orders")))


def orders_missed():
    missed_ones = [o for o in get("paper/orders.json", "orders") if not o["holds"]]
    return "; ".join(escaped(f"{o['case'].replace('_', ' ')}, {o['quantity']}") for o in missed_ones) or "none"


def surface():
    cells = []
    areas = [a for a in get("paper/surface.json", "areas") if a["particles_per_cell"] == 8]
    for form in ("standard", "published"):
        for area in areas:
            if area["form"] == form:
                cells.append([escaped(area["body"]), "ours" if form == "standard" else "as printed"] +
                             [f"{x:.3f}" for x in area["area_over_true_area"]])
    return rows(cells)


def surface_head():
    first = get("paper/surface.json", "areas")[0]
    return " & ".join(f"{n:g}" for n in first["cells_per_m"])


def edges():
    """The limits of the step that were found."""
    return [e for e in get("paper/stability.json", "edges") if e["has_limit"]]


def stability_cases():
    return str(len(get("paper/stability.json", "edges")))


def stability_safe():
    return str(sum(e["safe"] for e in get("paper/stability.json", "edges")))


def stability_least():
    return f"{min(e['factor'] for e in edges()):.2f}"


def stability_most():
    return f"{max(e['factor'] for e in edges()):.2f}"


# --- cost -----------------------------------------------------------------------------------------------------------


def accuracy():
    cells = []
    for case in get("paper/accuracy.json", "cases"):
        for quality in case["qualities"]:
            cells.append([escaped(case["case"].replace("_", " ")), quality["quality"], f"{quality['cells']:g}",
                          shown(100 * quality["error"], ".2g") + r"\,\%", shown(quality["particle_steps"], ".2g"),
                          shown(quality["cpu_s"], ".2g"), f"{quality['excess_cpu']:.2f}"])
    return rows(cells)


def effects():
    cells = []
    for c in get("paper/effects.json", "costs"):
        times = c["cpu_ns_per_particle_step"]
        cells.append([escaped(", ".join(c["effects"])), f"{statistics.median(times):.1f} ({min(times):.1f} to {max(times):.1f})",
                      f"{c['numbers_per_particle']:g}", f"{c['bytes_per_particle']:g}"])
    return rows(cells)


def measured_run(published):
    """The stored run of a row of table 1; nothing if there is none."""
    stem = published["scene"].split("/")[1]
    for file in sorted((ROOT / "experiments/table01_timings/measured").glob("*.json")):
        run = read(file.relative_to(ROOT).as_posix())
        if run["scene"]["file"].endswith(f"/{stem}.toml"):
            return run
    return None


def seconds_per_frame(run):
    s = run["summary"]
    return s["wall_s"] / (s["time_s"] * PER_FRAME)


def timings():
    cells = []
    for p in get("reference/published/table1.toml", "simulation"):
        run = measured_run(p)
        row = [escaped(p["name"]), f"{p['particles'] / 1000:.0f}", f"{p['seconds_per_frame']:g}", f"{p['machine']}"]
        if run is None:
            cells.append(row + ["--"] * 5 + ["not run"])
            continue
        s = run["summary"]
        per_frame = seconds_per_frame(run)
        cells.append(row + [f"{s['particles'] / 1000:.0f}", shown(per_frame, ".2g"), shown(p["seconds_per_frame"] / per_frame, ".2g"),
                            shown(s["particle_steps"] / s["wall_s"] / 1e6, ".2g"), f"{s['peak_memory_bytes'] / 1e6:.0f}",
                            f"{escaped(run['provenance']['machine']['cpu'].split('(')[0].strip())}, {stamp(run['provenance'])}"])
    return rows(cells)


def least_influence():
    """The smallest of the largest changes that leaving an effect out makes in a scene, over the error of its grid."""
    return shown(min(p["largest_change_over_error"] for p in get("paper/effects.json", "points")), ".2g")


def timing_ratios():
    runs = [(p, measured_run(p)) for p in get("reference/published/table1.toml", "simulation")]
    return [p["seconds_per_frame"] / seconds_per_frame(run) for p, run in runs if run]


def timings_run():
    return str(len(timing_ratios()))


def least_timing_ratio():
    return shown(min(timing_ratios()), ".2g")


def most_timing_ratio():
    return shown(max(timing_ratios()), ".2g")


MACHINES = ("amd-epyc-2", "intel-xeon-2")
BENCHMARKS = (("all effects, single precision, one thread", "Step/all/single/500K/threads:1/"),
              ("all effects, single precision, two threads", "Step/all/single/500K/threads:2/"),
              ("all effects, double precision, two threads", "Step/all/double/500K/threads:2/"),
              ("elastic cube, single precision, two threads", "Step/block/single/100^3/threads:2/"))
LIMITS = (("memory, two threads [GB/s]", "limit.triad_GB_per_s.all_threads"),
          ("multiply-adds, single, two threads [GFLOP/s]", "limit.single_GFLOPs.all_threads"))


def median_of(machine, benchmark, figure):
    values = [b[figure] for b in get(f"reference/machines/{machine}.json", "benchmarks")
              if b["name"].startswith(benchmark) and b["run_type"] == "iteration"]
    if not values:
        raise Unknown(f"{machine}.json has no {benchmark}")
    return statistics.median(values)


def machines():
    cells = [[name] + [f"{float(read(f'reference/machines/{m}.json')['context'][key]):.0f}" for m in MACHINES] for name, key in LIMITS]
    for name, benchmark in BENCHMARKS:
        cells.append([name + " [M/s]"] + [f"{median_of(m, benchmark, 'M/s'):.1f}" for m in MACHINES])
    cells.append(["share of the multiply-add limit, all effects, single, two threads"] +
                 [rf"{100 * median_of(m, BENCHMARKS[1][1], 'peak'):.0f}\,\%" for m in MACHINES])
    return rows(cells)


def drying():
    """The claims of experiment 2 that compare a slice with measured points."""
    cells = []
    for claim in kept("validation_drying")["claims"]:
        if claim["metric"] == "water_left" and "figures of the source" in claim["why"]:
            cells.append([code(claim["of"]), escaped(claim["why"].split(";")[0].split(":")[0]), shown(claim["measured"], ".2g"),
                          "holds" if claim["holds"] else r"\textbf{missed}"])
    return rows(cells)


def newest_day():
    """The newest day on which something was measured that is shown."""
    files = [f"paper/{name}.json" for name in ("accuracy", "departures", "effects", "orders", "stability", "surface")]
    days = [read(file)["provenance"]["date"][:10] for file in files]
    days += [result["provenance"]["date"][:10] for _, result in items() if result]
    return max(days)


TABLES = {f.__name__: f for f in (figures, missed, departures, orders, surface, surface_head, accuracy, effects, timings, machines, drying)}
DERIVED = {f.__name__: f for f in (claims_made, claims_held, items_of_paper, items_that_hold, items_that_miss,
                                   items_without_a_record, orders_made, orders_held, orders_missed, stability_cases, stability_safe,
                                   stability_least, stability_most, least_influence, timings_run, least_timing_ratio,
                                   most_timing_ratio, newest_day)}
FUNCTIONS = {"table": TABLES, "derived": DERIVED}
