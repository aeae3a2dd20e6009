"""Figures of fitted paths and motions, beside the peers: what run.py tells of them. Linkwright's and the peers' times are the
processor's, of one thread."""

import json
import os
import re

import numpy as np

from peers import fit_fourier, fit_scipy

TREE = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..")
SCIPY_SECONDS = 10
FOURIER_SECONDS = (0.3, 1, 10)
DRAWN_SECONDS = (0.3, 1)
EXACT = 1e-9  # of the diagonal
TABLED = "(quick|standard)"  # deep takes minutes over all that is drawn


def knife():
    """The example at angles of the crank, as a row of the bench; its requirements are the engine's alone."""
    with open(f"{TREE}/examples/flying_knife.json", encoding="utf-8") as file:
        points = json.loads(re.sub(r"^\s*//.*", "", file.read(), flags=re.MULTILINE))["task"]["points"]
    return {"points": np.array([complex(point["x"], point["y"]) for point in points]), "closed": True,
            "input_deg": [point["input_deg"] for point in points], "max_length": None, "published": None, "best_known": None}


def row_of(name):
    """The target of a row of the bench, and what its file tells about it."""
    if name == "flying_knife":
        return knife()
    target, _, bound = name.partition("_") if name.startswith("ell10") else (name, "", "")
    target = "kk18t" if target == "kk18" else target
    with open(f"{TREE}/data/approximate/{target}.json", encoding="utf-8") as file:
        of = json.load(file)
    told = of
    if bound:
        told = next(each for each in of["bounded"] if each["max_length"] == int(bound))
    elif name == "kk18":
        told = of["free_timing"]
    return {"points": np.array([complex(*point) for point in of["points"]]), "closed": of["closed"],
            "input_deg": of.get("input_deg") if told is of else None, "max_length": told.get("max_length"),
            "published": told.get("published_sum_of_squares"), "best_known": told["best_sum_of_squares"]}


def published_figures(entries, atlas):
    """Sum of squares and milliseconds of each row by effort, and what the peers find in some seconds."""
    figures = {}
    for name, entry in entries.items():
        _, row, effort = name.split("/")
        figures.setdefault(row, {})[effort] = {"sum_of_squares": entry["sum_of_squares"], "ms": entry["cpu_time"]}
    for name, of in figures.items():
        row = row_of(name)
        of["published"], of["best_known"] = row["published"], row["best_known"]
        best, starts = fit_scipy.fitted(row["points"], SCIPY_SECONDS, row["input_deg"])
        of["scipy"] = {"sum_of_squares": best, "seconds": SCIPY_SECONDS, "starts": starts}
        if row["closed"] and not row["input_deg"]:
            best, starts = fit_fourier.Search(atlas, row["points"], row["max_length"]).run(FOURIER_SECONDS)
            of["fourier"] = {"sum_of_squares": best, "seconds": FOURIER_SECONDS, "starts": starts}
    return figures


def counted(errors):
    """As the bench counts errors of drawn paths."""
    below = {f"below_{bound}": sum(each < float(bound) for each in errors) for bound in ("1e-9", "1e-7", "1e-5")}
    return {"count": len(errors), **below, "median": float(np.median(errors)), "worst": max(errors)}


def fourier_of_drawn(atlas, curves):
    """Of closed paths drawn at random: how many the search by Fourier descriptors finds again in some seconds, by seconds."""
    errors = {seconds: [] for seconds in DRAWN_SECONDS}
    cranks = dict.fromkeys(DRAWN_SECONDS, 0)
    for curve in curves:
        points = np.array([complex(*point) for point in curve["points"]])
        diagonal = np.hypot(np.ptp(points.real), np.ptp(points.imag))
        for seconds, best in zip(DRAWN_SECONDS, fit_fourier.Search(atlas, points).run(DRAWN_SECONDS)[0]):
            errors[seconds].append(min(1.0, float(np.sqrt(best / len(points)) / diagonal)))
            cranks[seconds] += curve["type"] == "crank_rocker" and errors[seconds][-1] < EXACT
    return {f"{seconds} s": {**counted(errors[seconds]), "crank_rockers_below_1e-9": cranks[seconds]}
            for seconds in DRAWN_SECONDS}


def gallery_figures(entries):
    """Of the gallery's paths by effort: error and milliseconds of each."""
    figures = {}
    for name, entry in entries.items():
        _, curve, effort = name.split("/")[:3]
        figures.setdefault(effort, {})[curve] = {"rms_over_diagonal": entry["rms_over_diagonal"], "ms": entry["cpu_time"]}
    return figures


def counters(entry):
    """What a benchmark counted itself."""
    known = {"name", "run_name", "run_type", "repetitions", "repetition_index", "threads", "iterations", "real_time",
             "cpu_time", "time_unit", "family_index", "per_family_instance_index"}
    return {key: value for key, value in entry.items() if key not in known}


def figures(run_benchmarks, curves):
    """All of them. `run_benchmarks`: entries by name of the benchmarks that match; `curves`: closed paths drawn at random."""
    atlas = fit_fourier.Atlas()
    once = lambda entries: {name.split("/", 1)[1].replace("/iterations:1", ""): counters(entry) for name, entry in entries.items()}
    return {
        "published": published_figures(run_benchmarks("^fit/"), atlas),
        "gallery": gallery_figures(run_benchmarks("^fit_gallery/.*" + TABLED)),
        "drawn": {**once(run_benchmarks("^fit_drawn/.*" + TABLED)), "closed/fourier": fourier_of_drawn(atlas, curves)},
        "poses": {name.split("/", 1)[1]: {"rms": entry["rms"], "ms": entry["cpu_time"]}
                  for name, entry in run_benchmarks("^fit_poses/").items()},
        "drawn_poses": once(run_benchmarks("^fit_drawn_poses/.*" + TABLED)),
        "pivots_ms": {name.split("/", 1)[1]: entry["cpu_time"] for name, entry in run_benchmarks("^fit_pivots/").items()},
    }


def cell(value):
    return "–" if value is None or not np.isfinite(value) else f"{value:.5g}"


def print_published(rows):
    print("\nnearest paths: sum of squares and ms of the processor by effort; scipy's need neither be drivable nor keep lengths")
    seconds = "".join(f"{f'Fourier {each} s':>14}" for each in FOURIER_SECONDS)
    print(f"  {'':<12}{'published':>12}{'best known':>12}{'quick':>12}{'ms':>5}{'standard':>12}{'ms':>5}"
          f"{f'scipy {SCIPY_SECONDS} s':>12}{seconds}")
    for name, of in rows.items():
        ours = "".join(f"{cell(of[effort]['sum_of_squares']):>12}{of[effort]['ms']:5.0f}" for effort in ("quick", "standard"))
        theirs = of["fourier"]["sum_of_squares"] if "fourier" in of else [None] * len(FOURIER_SECONDS)
        fourier = "".join(f"{cell(each):>14}" for each in theirs)
        print(f"  {name:<12}{cell(of['published']):>12}{cell(of['best_known']):>12}{ours}"
              f"{cell(of['scipy']['sum_of_squares']):>12}{fourier}")


def print_gallery(of):
    for effort, curves in of.items():
        errors, ms = ([each[key] for each in curves.values()] for key in ("rms_over_diagonal", "ms"))
        print(f"  gallery, {effort}: {sum(each < EXACT for each in errors)} of {len(errors)} below {EXACT:g} of the diagonal, "
              f"worst {max(errors):.1e}, {sum(ms) / len(ms):.0f} ms on average, {max(ms):.0f} at most")


def print_drawn(of):
    print("\npaths drawn at random, root mean square over the diagonal")
    for name, each in of.items():
        for title, told in (each.items() if name == "closed/fourier" else [("", each)]):
            ms = f"; {told['mean_ms']:.0f} ms on average, {told['worst_ms']:.0f} at most" if "mean_ms" in told else ""
            print(f"  {f'{name} {title}':<21} of {told['count']:.0f}: {told['below_1e-9']:.0f} below 1e-9, "
                  f"{told['below_1e-7']:.0f} below 1e-7, {told['below_1e-5']:.0f} below 1e-5; median {told['median']:.1e}, "
                  f"worst {told['worst']:.1e}; {told['crank_rockers_below_1e-9']:.0f} crank-rockers{ms}")


def print_poses(published, drawn):
    print("\nnear poses")
    for name, each in published.items():
        print(f"  {name:<28}rms {each['rms']:.6g} in {each['ms']:.0f} ms")
    print("  drawn at random, beside 400 random starts: nearer, as near to 1 %, farther (at most how much; where nothing was "
          "found); ms, theirs")
    for name, each in drawn.items():
        print(f"  {name:<24}{each['better']:3.0f}{each['equal']:4.0f}{each['worse']:4.0f}  ({each['worst_ratio']:.2f}×; "
              f"{each['none']:.0f}){each['mean_ms']:6.0f} (at most {each['worst_ms']:.0f}){each['random_mean_ms']:6.0f}")


def print_figures(of):
    print_published(of["published"])
    print_gallery(of["gallery"])
    print_drawn(of["drawn"])
    print_poses(of["poses"], of["drawn_poses"])
    for name, ms in of["pivots_ms"].items():
        print(f"  pivots, {name:<28}{ms:8.1f} ms")
