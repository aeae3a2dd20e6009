#!/usr/bin/env python3
"""Mutation test of the classifier: every wrong sign must be caught.

Builds classifier_check.cpp with src/analysis/defects.cpp and a copy of pair_verdict.hpp in which one thing is wrong. The
right source must agree with driving everywhere, each mutant must not.

usage: classifier_mutants.py SOURCE_DIR LIBRARY CXX [FLAG...]   (linker flags among them)
"""

import pathlib
import subprocess
import sys
import tempfile

MUTANTS = [
    ("joint sign at the output", "between + driven_turn", "between - driven_turn"),
    ("joint sign at the input's moving pivot", "between + turn", "between - turn"),
    ("first excess", "t1 = gh - ab", "t1 = ab - gh"),
    ("second excess", "t2 = gb - ah", "t2 = ah - gb"),
    ("third excess", "t3 = hb - ga", "t3 = ga - hb"),
    ("two triple rockers exchanged", "select(p3, code(0), code(4))", "select(p3, code(0), code(6))"),
    ("circuit of a crank not looked at", "(input_cranks & output_changes) |", "(input_cranks & n3) |"),
    ("sector test loose", "Mask(in_negative & out_positive)", "Mask(in_negative | out_positive)"),
    ("sector test turned", "in_negative = turn_in < 0.0", "in_negative = turn_in > 0.0"),
    ("passing along the frame always possible", "(passes_0 & negated(limits.can_pass_0)) |", ""),
    ("passing opposite to the frame always possible", "| (passes_pi & negated(limits.can_pass_pi))", ""),
    ("last pose left out of the angle", "larger(at_pose(0), at_pose(Poses - 1))", "at_pose(0)"),
    ("angle along the frame and opposite exchanged",
     "magnitude<Width>(still + swing), magnitude<Width>(still - swing)",
     "magnitude<Width>(still - swing), magnitude<Width>(still + swing)"),
    ("sense of the drive exchanged", "driver.wide & ccw_bit", "driver.wide & cw_bit"),
]


def build_and_run(source_dir, library, compiler, flags, header, folder):
    (folder / "analysis").mkdir(parents=True)
    (folder / "analysis" / "pair_verdict.hpp").write_text(header)
    (folder / "defects.cpp").write_text((source_dir / "src/analysis/defects.cpp").read_text())
    program = folder / "check"
    command = [compiler, "-std=c++20", "-O1", "-w", f"-I{folder}", f"-I{source_dir}/include", f"-I{source_dir}/src",
               f"-I{source_dir}/tests", str(source_dir / "tests/mutants/classifier_check.cpp"), str(folder / "defects.cpp"),
               str(source_dir / "tests/support/random_four_bar.cpp"), library, "-o", str(program), *flags]
    subprocess.run(command, check=True)
    return subprocess.run([str(program)], capture_output=True, text=True, check=False)


def main():
    source_dir, library, compiler, *flags = sys.argv[1:]
    source_dir = pathlib.Path(source_dir)
    header = (source_dir / "src/analysis/pair_verdict.hpp").read_text()
    failures = []
    with tempfile.TemporaryDirectory() as scratch:
        run = lambda name, text: build_and_run(source_dir, library, compiler, flags, text, pathlib.Path(scratch) / name)
        right = run("right", header)
        print("as it is:", right.stdout.strip())
        if right.returncode != 0:
            failures.append("the classifier itself disagrees with driving")
        for number, (name, before, after) in enumerate(MUTANTS):
            if header.count(before) != 1:
                failures.append(f"'{before}' stands {header.count(before)} times in pair_verdict.hpp: mend this list")
                continue
            result = run(str(number), header.replace(before, after))
            print(f"{name}: {result.stdout.strip()}")
            if result.returncode == 0:
                failures.append(f"not caught: {name}")
    for failure in failures:
        print("FAILED:", failure)
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
