"""What the atlases share: a sweep run by the program, its columns, and tables of rows."""

import argparse
import csv
import itertools
import json
import re
import subprocess
import sys
from pathlib import Path

import h5py
import numpy

ROOT = Path(__file__).resolve().parents[2]
ATLAS = ROOT / "data/atlas"


def example(name):
    """The problem of examples/NAME.json."""
    text = (ROOT / f"examples/{name}.json").read_text(encoding="utf-8")
    return json.loads(re.sub(r"^\s*//.*$", "", text, flags=re.MULTILINE))


def arguments(description):
    """A parser with what every generator takes: the program, and a folder where sweeps are kept and gone on with."""
    parser = argparse.ArgumentParser(description=description)
    parser.add_argument("--program", default=str(ROOT / "build/release/bin/linkwright"))
    parser.add_argument("--work", type=Path, default=ROOT / "build/atlas", help="folder of the sweeps; what is there goes on")
    return parser


def column(values):
    return values.astype(str) if values.dtype.kind == "S" else values


def table_of(path):
    """{"samples": {column: array}, "linkages": {…}} of a sweep's HDF5 file."""
    with h5py.File(path) as file:
        return {group: {name: column(data[:]) for name, data in file[group].items()} for group in ("samples", "linkages")}


def swept(options, name, problem, sampling, vary, keep):
    """The table of the sweep NAME; where it is in the folder of the sweeps already, and of the same content, as it is."""
    options.work.mkdir(parents=True, exist_ok=True)
    sweep = {"linkwright": 1, "problem": problem, "sampling": sampling, "vary": vary, "keep": keep}
    path, output = options.work / f"{name}.json", options.work / f"{name}.h5"
    text = json.dumps(sweep)
    begun = path.exists() and path.read_text(encoding="utf-8") == text
    if not (begun and output.exists()):
        path.write_text(text, encoding="utf-8")
        run(options.program, "sweep", path, "-o", output, "--resume" if begun else "--overwrite")
    return table_of(output)


def run(program, *words):
    """Runs the program; its mistake, where there is one, is that of the generator."""
    done = subprocess.run([program, *map(str, words)], capture_output=True, text=True, check=False)
    if done.returncode:
        sys.exit(done.stderr)


def grid(**values):
    """The vary of a grid over numbers of the problem: {column: (pointer or pointers, values)}."""
    return [{"name": name, "at": at, "values": list(map(float, of))} for name, (at, of) in values.items()]


def linkages_with(table, *names):
    """Rows, a dict each: the columns of /linkages and, of its sample, those named."""
    samples, linkages = table["samples"], table["linkages"]
    place = {number: i for i, number in enumerate(samples["sample"])}
    return [{**{name: samples[name][place[number]] for name in names}, **{name: values[i] for name, values in linkages.items()}}
            for i, number in enumerate(linkages["sample"])]


def is_free(row):
    """Of a linkage: neither order nor branch nor circuit defect."""
    return not any(row[f"defects.{kind}"] == 1 for kind in ("order", "branch", "circuit"))


def word(value):
    """A number in twelve digits, so that a row can be solved again."""
    if isinstance(value, (float, numpy.floating)):
        return "" if numpy.isnan(value) else f"{value:.12g}"
    return str(value)


def write_table(path, columns, rows):
    """A CSV file, or HDF5 with a data set to a column; rows may come one by one."""
    path.parent.mkdir(parents=True, exist_ok=True)
    if path.suffix == ".h5":
        write_hdf5(path, columns, rows)
        return
    with path.open("w", encoding="utf-8", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(columns)
        writer.writerows([word(row[name]) for name in columns] for row in rows)


def write_hdf5(path, columns, rows, at_once=10_000):
    rows, done = iter(rows), 0
    with h5py.File(path, "w") as file:
        while block := list(itertools.islice(rows, at_once)):
            for name in columns:
                values = numpy.array([row[name] for row in block])
                values = values.astype("S32") if values.dtype.kind == "U" else values
                if not done:
                    file.create_dataset(name, (0,), values.dtype, maxshape=(None,), chunks=(at_once,), compression="gzip")
                file[name].resize((done + len(block),))
                file[name][done:] = values
            done += len(block)


def read_table(path):
    """Rows of a CSV file, numbers where they are numbers."""
    def value(text):
        try:
            return float(text)
        except ValueError:
            return text
    with path.open(encoding="utf-8") as file:
        return [{name: value(text) for name, text in row.items()} for row in csv.DictReader(file)]
