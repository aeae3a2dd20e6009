#!/usr/bin/python3
"""Linkwright's region kernels, maps of straight lines and of paths beside numpy, the page's engine beside the native one, and the
dyads of five poses and of five orientations beside PHCpack, in one run: script/bench calls this.

The two take turns, so that what else the machine does hits both; a ratio within a run counts, an absolute figure does
not. Options of Google Benchmark (--benchmark_filter=…) run the benchmarks alone.

usage: run.py linkwright_bench [--rounds N] [--samples N] [--fits] [--save FILE]
"""

import argparse
import json
import os
import platform
import statistics
import subprocess
import sys

import fits
from peers import (burmester_phc, five_orientations_phc, loads_numpy, path_numpy, path_phc, phc, region_numpy, sphere_numpy,
                   straight_line_numpy, tolerances_numpy)

TASKS = ("landing_gear", "drawer_hinge", "tailgate")


def parse(arguments):
    parser = argparse.ArgumentParser(prog="script/bench", description=__doc__.split("\n", 1)[0])
    parser.add_argument("bench", help="path of linkwright_bench")
    parser.add_argument("--rounds", type=int, default=5, help="turns of each (default 5)")
    parser.add_argument("--samples", type=int, default=1000, help="N of the N×N region (default 1000; 100 … 10000)")
    parser.add_argument("--five", type=int, default=1000, help="tasks of five poses for phc, 25 ms each (default 1000)")
    parser.add_argument("--five-orientations", type=int, default=20, help="the same of orientations (default 20; 1000 for a check)")
    parser.add_argument("--fits", action="store_true", help="fitted paths and motions alone")
    parser.add_argument("--save", metavar="FILE", help="write the figures as JSON, as bench/results/region.json")
    return parser.parse_known_args(arguments)


def run_benchmarks(bench, pattern, seconds="0.1"):
    """Benchmarks that match, by name, as Google Benchmark reports them."""
    command = [bench, f"--benchmark_filter={pattern}", "--benchmark_format=json", f"--benchmark_min_time={seconds}"]
    answer = subprocess.run(command, check=True, capture_output=True, text=True).stdout
    found = json.loads(answer)["benchmarks"] if answer.strip() else []
    return {entry["name"].removesuffix("/real_time"): entry for entry in found if not entry.get("error_occurred")}


def add_round(figures, bench, samples, dumps):
    """One turn of each: nanoseconds a mechanism, by task and contender."""
    for task in TASKS:
        for name, entry in run_benchmarks(bench, f"^region/{task}/.*/{samples}/").items():
            contender = name.removeprefix(f"region/{task}/").removesuffix(f"/{samples}")
            figures.setdefault((task, contender), []).append(entry["ns_per_mechanism"])
        figures.setdefault((task, "numpy"), []).append(min(region_numpy.measure(dumps[task], 1)))


def summary(values):
    return {"median": statistics.median(values), "min": min(values), "max": max(values)}


def processor():
    """The machine's name for itself."""
    try:
        with open("/proc/cpuinfo", encoding="utf-8") as file:
            lines = dict(line.split(":", 1) for line in file.read().split("\n\n")[0].splitlines())
        values = {key.strip(): value.strip() for key, value in lines.items()}
        return f"{values['model name']} (family {values['cpu family']}, model {values['model']})"
    except (OSError, KeyError, ValueError):
        return platform.processor() or platform.machine()


def print_table(title, rows):
    print(f"\n{title}")
    for label, s, ratio in rows:
        print(f"  {label:<24}{s['median']:10.2f}{s['min']:10.2f}{s['max']:10.2f}{ratio:9.1f}×")


def contender_tables(table):
    for task in TASKS:
        best = min(s["min"] for (of, contender), s in table.items() if of == task and "threads:1" in contender)
        rows = [(contender, s, s["min"] / best) for (of, contender), s in table.items() if of == task]
        print_table(f"{task}: ns a mechanism, median, min, max; min over the best of one thread", rows)


def other_figures(bench, table):
    """The widest instruction set over sizes, 10⁴ to 10⁸ mechanisms, on one and two threads; first maps; readers of maps."""
    widest = [contender for _, contender in table if contender.endswith("/threads:1")][-1].split("/")[0]
    found = run_benchmarks(bench, f"^region/tailgate/{widest}/|^first_region|^counts|^filter")
    return {name: entry["ns_per_mechanism"] for name, entry in found.items()}


def page_figures(bench):
    """What the page asks of its engine: milliseconds by question, of the native engine and of the page's own in node."""
    script = os.path.join(os.path.dirname(os.path.abspath(__file__)), "../web/scripts/bench.mjs")
    native = run_benchmarks(bench, "^session/")
    try:
        page = json.loads(subprocess.run(["node", script], check=True, capture_output=True, text=True).stdout)
    except (OSError, subprocess.CalledProcessError):
        return None  # no node, or the page's engine is not built: script/build
    return {question: {"native": native[f"session/{question}"]["real_time"], "page": ms} for question, ms in page.items()}


def print_page_figures(figures):
    if figures is None:
        return print("\nthe page's engine was not timed: script/build builds it")
    print("\nwhat the page asks: ms natively (two threads), ms in WebAssembly (one), ratio")
    for question, ms in figures.items():
        print(f"  {question:<24}{ms['native']:8.2f}{ms['page']:8.2f}{ms['page'] / ms['native']:9.1f}×")
    return None


def five_figures(bench, benchmarks, peer, dump, count):
    """All dyads of five positions: ns a task of ours, many at once and one with care, and what PHCpack found and took."""
    ours = {name.removeprefix(f"{benchmarks}/"): entry["ns_per_task"]
            for name, entry in run_benchmarks(bench, f"^{benchmarks}/").items()}
    if not phc.is_installed():
        return {"ns_per_task": ours, "phc": None}
    tasks = subprocess.run([bench, dump, str(count)], check=True, capture_output=True, text=True).stdout
    return {"ns_per_task": ours, "phc": peer.measure(json.loads(tasks))}


def print_five_figures(title, figures, roots):
    print(f"\n{title}: ns of processor time a task, one thread")
    for name, ns in figures["ns_per_task"].items():
        print(f"  {name:<24}{ns:12.0f}")
    theirs = figures["phc"]
    if theirs is None:
        return print("  phc is not installed (Debian package phcpack): no peer")
    fastest = min(figures["ns_per_task"].values())
    ratio, inside = (1e6 * theirs[key] / fastest for key in ("ms_per_task", "ms_per_task_inside"))
    print(f"  {'phc -b':<24}{1e6 * theirs['ms_per_task']:12.0f}{ratio:9.0f}×   (its own work alone {inside:.0f}×)")
    print(f"  {theirs['tasks']} tasks: phc found {theirs['roots_found']} roots of {roots * theirs['tasks']}, counts differ on "
          f"{theirs['tasks_whose_counts_differ']}; roots differ by {theirs['worst_difference']:.1e} at most, "
          f"{theirs['median_difference']:.1e} in the middle; phc asked again in double-double on "
          f"{theirs['asked_again_in_double_double']}")
    return None


def sphere_figures(bench, samples, rounds):
    """The spherical kernel and numpy in turns: nanoseconds a mechanism; sizes; a task to its map, milliseconds."""
    dump = json.loads(subprocess.run([bench, "--dump-sphere", str(samples)], check=True, capture_output=True, text=True).stdout)
    figures = {}
    for _ in range(rounds):
        for name, entry in run_benchmarks(bench, f"^sphere_region/.*/{samples}/").items():
            contender = name.removeprefix("sphere_region/folding_wing/").removesuffix(f"/{samples}")
            figures.setdefault(contender, []).append(entry["ns_per_mechanism"])
        figures.setdefault("numpy", []).append(min(sphere_numpy.measure(dump, 1)))
    sizes = run_benchmarks(bench, "^sphere_region/.*/threads:1/")
    return {
        "ns_per_mechanism": {contender: summary(values) for contender, values in figures.items()},
        "sizes_ns_per_mechanism": {name: entry["ns_per_mechanism"] for name, entry in sizes.items()},
        "task_to_map_ms": run_benchmarks(bench, "^sphere_task_to_map")["sphere_task_to_map/400"]["real_time"],
    }


def print_sphere_figures(figures):
    table = figures["ns_per_mechanism"]
    best = min(s["min"] for contender, s in table.items() if "threads:1" in contender)
    rows = [(contender, s, s["min"] / best) for contender, s in table.items()]
    print_table("folding wing, on the sphere: ns a mechanism, median, min, max; min over the best of one thread", rows)
    for name, ns in figures["sizes_ns_per_mechanism"].items():
        print(f"  {name:<52}{ns:8.2f}")
    print(f"  four orientations to the map of 400 × 400, one thread: {figures['task_to_map_ms']:.2f} ms")


def line_figures(bench, rounds):
    """Maps of straight lines and numpy in turns: nanoseconds of the processor a cell; geometry, estimates, exact measures
    and maps of each case; the search, milliseconds."""
    dump = json.loads(subprocess.run([bench, "--dump-lines", "200"], check=True, capture_output=True, text=True).stdout)
    beside = {"map, one thread": [], "numpy": []}
    for _ in range(rounds):
        for entry in run_benchmarks(bench, "^line_map/straight_indicator/threads:1/200/").values():
            beside["map, one thread"].append(entry["processor_ns_per_cell"])
        beside["numpy"].append(min(straight_line_numpy.measure(dump, 1)))
    counters = {"line_geometry": "ns_per_cell", "line_estimate": "ns_per_linkage", "line_stroke": "us_per_linkage",
                "line_strip": "us_per_linkage", "line_map": "processor_ns_per_cell", "line_search": "real_time"}
    found = {kind: {name.removeprefix(f"{kind}/"): entry[counter] for name, entry in run_benchmarks(bench, f"^{kind}/").items()}
             for kind, counter in counters.items()}
    return {"ns_per_cell": {contender: summary(values) for contender, values in beside.items()}, **found}


def print_line_figures(figures):
    table = figures["ns_per_cell"]
    best = table["map, one thread"]["min"]
    print_table("straight lines, the indicator's map: ns a cell, median, min, max; min over the map's",
                [(contender, s, s["min"] / best) for contender, s in table.items()])
    units = {"line_geometry": "ns a place, all its linkages", "line_estimate": "ns a linkage", "line_stroke": "µs a linkage",
             "line_strip": "µs a linkage", "line_map": "ns of all processors a cell", "line_search": "ms"}
    for kind, unit in units.items():
        print(f"\n  {kind}: {unit}")
        for name, value in figures[kind].items():
            print(f"  {name:<52}{value:9.1f}")


def tolerance_figures(bench, rounds):
    """Samples of a linkage and numpy in turns: nanoseconds of the processor a sample and position; what maps of each kind
    take, nanoseconds a cell."""
    dump = json.loads(subprocess.run([bench, "--dump-tolerances", "200000"], check=True, capture_output=True, text=True).stdout)
    beside = {"numpy": []}
    for _ in range(rounds):
        for name, entry in run_benchmarks(bench, "^tolerances/samples").items():
            beside.setdefault(name.removeprefix("tolerances/").removesuffix("/real_time"), []).append(1e9 / entry["items_per_second"])
        beside["numpy"].append(min(tolerances_numpy.measure(dump, 1)))
    ns = lambda pattern: {name: 1e9 / entry["items_per_second"] for name, entry in run_benchmarks(bench, pattern).items()}
    return {"ns_per_sample_and_position": {contender: summary(values) for contender, values in beside.items()},
            "error": ns("^tolerances/error"), "maps": ns("^tolerance_map/")}


def print_tolerance_figures(figures):
    table = figures["ns_per_sample_and_position"]
    best = min(s["min"] for s in table.values())
    print_table("tolerances: ns a sample and position, median, min, max; min over the best",
                [(contender, s, s["min"] / best) for contender, s in table.items()])
    for kind, unit in {"error": "ns a linkage in four poses", "maps": "ns a cell"}.items():
        print(f"\n  {kind}: {unit}")
        for name, value in figures[kind].items():
            print(f"  {name:<52}{value:9.1f}")


def load_figures(bench, rounds):
    """The hand's forces over a map, and numpy in turns: nanoseconds of the processor a linkage that has forces, and a cell;
    what a search and a list pay for one, microseconds."""
    dump = json.loads(subprocess.run([bench, "--dump-loads", "400"], check=True, capture_output=True, text=True).stdout)
    beside, cells = {"numpy, positions, weight alone": []}, {}
    for _ in range(rounds):
        for name, entry in run_benchmarks(bench, "^load_map/").items():
            beside.setdefault(name, []).append(entry["ns_per_linkage"])
            cells.setdefault(name, []).append(entry["ns_per_task"])
        beside["numpy, positions, weight alone"] += loads_numpy.measure(dump, 1)
    alone = {name: entry["ns_per_task"] / 1000 for name, entry in run_benchmarks(bench, "^loads/").items()}
    return {"ns_per_linkage": {contender: summary(values) for contender, values in beside.items()},
            "ns_per_cell": {contender: summary(values) for contender, values in cells.items()}, "us_alone": alone}


def print_load_figures(figures):
    table = figures["ns_per_linkage"]
    best = min(s["min"] for s in table.values())
    print_table("loads: ns of the processor a linkage, median, min, max; min over the best",
                [(contender, s, s["min"] / best) for contender, s in table.items()])
    for name, s in figures["ns_per_cell"].items():
        print(f"  {name:<32}{s['min']:9.2f} ns a cell of the whole map")
    for name, us in figures["us_alone"].items():
        print(f"  {name:<32}{us:9.1f} µs")


def path_figures(bench, rounds):
    """Maps of paths, and numpy in turns: nanoseconds of the processor a cell. Four-bars between two pivots, and PHCpack:
    milliseconds of the processor."""
    dump = json.loads(subprocess.run([bench, "--dump-path", "60"], check=True, capture_output=True, text=True).stdout)
    beside, between = {"numpy": []}, []
    for _ in range(rounds):
        for name, entry in run_benchmarks(bench, "^map_of_(path|its_poses)").items():
            beside.setdefault(name, []).append(entry["ns_per_task"])
        between.append(next(iter(run_benchmarks(bench, "^between_pivots").values()))["cpu_time"])
        taken, differ = path_numpy.measure(dump["arms"], 1)
        beside["numpy"] += taken
    return {"ns_per_cell": {contender: summary(values) for contender, values in beside.items()},
            "places_whose_counts_differ": differ,
            "between_pivots_ms": summary(between),
            "between_pivots_phc": path_phc.measure(dump["between"]) if phc.is_installed() else None}


def print_path_figures(figures):
    table = figures["ns_per_cell"]
    arms = table["map_of_path/arms_of_mixer"]["min"]
    print_table("paths: ns of the processor a cell, median, min, max; min over that of the mixer's arms",
                [(contender, s, s["min"] / arms) for contender, s in table.items()])
    print(f"  numpy's numbers of linkages differ at {100 * figures['places_whose_counts_differ']:.2f} % of the places")
    ours, theirs = figures["between_pivots_ms"]["min"], figures["between_pivots_phc"]
    print(f"  five points and both pivots: {ours:.2f} ms")
    if theirs:
        print(f"  phc -b: {min(theirs['ms']):.0f} ms, {min(theirs['ms']) / ours:.0f}×; real ones differ by {theirs['worst_difference']:.1e}")


def fit_figures(bench):
    """Paths and motions fitted, and their peers."""
    curves = json.loads(subprocess.run([bench, "--dump-curves"], check=True, capture_output=True, text=True).stdout)
    return fits.figures(lambda pattern: run_benchmarks(bench, pattern), curves)


def only_fits(options):
    """The table of fits by itself."""
    print(f"{processor()}, {os.cpu_count()} threads")
    of = fit_figures(options.bench)
    fits.print_figures(of)
    if options.save:
        write(options.save, {"machine": processor(), "threads": os.cpu_count(), "fits": of})
    return 0


def main(arguments):
    options, rest = parse(arguments)
    if options.fits:
        return only_fits(options)
    if rest:
        os.execv(options.bench, [options.bench, *rest])
    dumps = {task: json.loads(subprocess.run([options.bench, "--dump", task, str(options.samples)], check=True,
                                             capture_output=True, text=True).stdout) for task in TASKS}
    figures = {}
    for done in range(options.rounds):
        print(f"\rround {done + 1} of {options.rounds} …", end="", file=sys.stderr, flush=True)
        add_round(figures, options.bench, options.samples, dumps)
    print(file=sys.stderr)
    table = {key: summary(values) for key, values in figures.items()}
    sizes = other_figures(options.bench, table)
    roofline = {name: entry["per_ns"] for name, entry in run_benchmarks(options.bench, "mul_add|sqrt|^write").items()}

    print(f"{processor()}, {os.cpu_count()} threads; {options.samples} × {options.samples} pairs, 18 bytes each")
    print("numpy's counts of types and defects equal the kernel's on all tasks")
    contender_tables(table)
    print("\nns a mechanism, over sizes, and beside the kernel")
    for name, ns in sizes.items():
        print(f"  {name:<52}{ns:8.2f}")
    print("\nthis machine, one thread: results (bytes, for write) a ns")
    for name, rate in roofline.items():
        print(f"  {name:<24}{rate:8.2f}")
    page = page_figures(options.bench)
    print_page_figures(page)
    sphere = sphere_figures(options.bench, options.samples, options.rounds)
    print_sphere_figures(sphere)
    lines = line_figures(options.bench, options.rounds)
    print_line_figures(lines)
    tolerances = tolerance_figures(options.bench, options.rounds)
    print_tolerance_figures(tolerances)
    loads = load_figures(options.bench, options.rounds)
    print_load_figures(loads)
    paths = path_figures(options.bench, options.rounds)
    print_path_figures(paths)
    fitted = fit_figures(options.bench)
    fits.print_figures(fitted)
    five = {
        "paths": paths,
        "fits": fitted,
        "sphere": sphere,
        "straight_lines": lines,
        "tolerances": tolerances,
        "loads": loads,
        "five_poses": five_figures(options.bench, "burmester_points", burmester_phc, "--dump-five", options.five),
        "five_orientations": five_figures(options.bench, "five_orientations", five_orientations_phc, "--dump-five-orientations",
                                          options.five_orientations),
    }
    print_five_figures("five poses, all Burmester points", five["five_poses"], roots=4)
    print_five_figures("five orientations, all dyads", five["five_orientations"], roots=6)
    if options.save:
        save(options, table, sizes, roofline, page, five)
    return 0


def save(options, table, sizes, roofline, page, five):
    figures = {
        "machine": processor(),
        "threads": os.cpu_count(),
        "samples": options.samples,
        "rounds": options.rounds,
        "ns_per_mechanism": {task: {contender: s for (of, contender), s in table.items() if of == task} for task in TASKS},
        "sizes_ns_per_mechanism": sizes,
        "roofline_per_ns": roofline,
        "page_ms": page,
        **five,
    }
    write(options.save, figures)


def write(path, figures):
    os.makedirs(os.path.dirname(path) or ".", exist_ok=True)
    with open(path, "w", encoding="utf-8") as file:
        json.dump(figures, file, indent=1)
        file.write("\n")


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
