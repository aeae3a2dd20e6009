#!/usr/bin/env python3
"""Mutation test of the classifier: every wrong sign must be caught.

Builds classifier_check.cpp with copies of src/analysis/defects.cpp and pair_verdict.hpp in which one thing is wrong. The
right source must agree with driving everywhere, each mutant must not.

usage: classifier_mutants.py SOURCE_DIR LIBRARY CXX [FLAG...]   (linker flags among them)
"""

import os
import pathlib
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor

MUTANTS = [
    ("joint sign at the output", "(driver.arm_y[j] - d.frame_y)", "(driver.arm_y[j] + d.frame_y)"),
    ("joint sign at the input's moving pivot", "(arm_x(j) + d.frame_x)", "(arm_x(j) - d.frame_x)"),
    ("joint sign at the input's fixed pivot", "return d.frame_x * driver.arm_y[j] -", "return d.frame_x * driver.arm_y[j] +"),
    ("first excess", "t1 = gh - ab", "t1 = ab - gh"),
    ("second excess", "t2 = (g + b) - (a + h)", "t2 = (a + h) - (g + b)"),
    ("third excess", "t3 = (h + b) - (g + a)", "t3 = (g + a) - (h + b)"),
    ("types exchanged by their lowest bit", "(s.n2 & s.n3)))", "(s.n2 & s.p3)))"),
    ("types exchanged by their second bit", "(s.n2 & s.p3))", "(s.n2 & s.n3))"),
    ("triple rockers taken for Grashof's", "~(s.p1 ^ s.p2 ^ s.p3)", "(s.p1 ^ s.p2 ^ s.p3)"),
    ("circuit of a crank not looked at", "circuit = s.input_is_crank() & output_changes", "circuit = s.n3 & output_changes"),
    ("circuit of a rocker-crank not looked at", "circuit |= lanes & changes_sign<Width, Poses>([&](int j) { return pairs.at_input_circle(j); });", ";"),
    ("circuit of a double rocker not looked at", "circuit |= lanes & changes_sign<Width, Poses>([&](int j) { return pairs.at_input_center(j); });", ";"),
    ("sector test loose", ": in_negative & out_positive", ": in_negative | out_positive"),
    ("sector test turned", "in_negative = less<Width>(turn_in, Real{})", "in_negative = less<Width>(Real{}, turn_in)"),
    ("passing along the frame always possible", "(passes_0 & ~limits.can_pass_0) |", ""),
    ("passing opposite to the frame always possible", "| (passes_pi & ~limits.can_pass_pi)", ""),
    ("last pose left out of the angle", "std::min(angle_at(0), angle_at(input.arm.size() - 1))", "angle_at(0)"),
    ("angle along the frame and opposite exchanged", "passes_0 ? angle_at(std::abs(l.ground - l.input))",
     "passes_0 ? angle_at(l.ground + l.input)"),
    ("what the driver passes exchanged", "verdict.passes_0 = best.passes_0;", "verdict.passes_0 = best.passes_pi;"),
    ("sense of the drive exchanged", "driver.at_least_half_turn & ccw_bit", "driver.at_least_half_turn & cw_bit"),
]


class Workshop:
    """Compiles what every mutant shares once; a mutant is one unit and a link."""

    def __init__(self, source_dir, library, compiler, flags, scratch):
        self.source_dir, self.library, self.compiler, self.flags, self.scratch = source_dir, library, compiler, flags, scratch
        shared = ("tests/mutants/classifier_check.cpp", "tests/support/random_four_bar.cpp")
        self.shared = [scratch / (pathlib.Path(path).stem + ".o") for path in shared]
        for path, target in zip(shared, self.shared):
            self.compile(source_dir / path, target, [])

    def compile(self, source, target, before):
        command = [self.compiler, "-std=c++20", "-O1", "-w", *before, f"-I{self.source_dir}/include", f"-I{self.source_dir}/src",
                   f"-I{self.source_dir}/tests", "-c", str(source), "-o", str(target)]
        subprocess.run(command, check=True)

    def run(self, name, header, source):
        """The check's result with these two files in place of the library's."""
        folder = self.scratch / name
        (folder / "analysis").mkdir(parents=True)
        (folder / "analysis" / "pair_verdict.hpp").write_text(header)
        (folder / "defects.cpp").write_text(source)
        self.compile(folder / "defects.cpp", folder / "defects.o", [f"-I{folder}"])
        program = folder / "check"
        subprocess.run([self.compiler, *map(str, self.shared), str(folder / "defects.o"), self.library, "-o", str(program),
                        *self.flags], check=True)
        return subprocess.run([str(program)], capture_output=True, text=True, check=False)


def main():
    source_dir, library, compiler, *flags = sys.argv[1:]
    source_dir = pathlib.Path(source_dir)
    header = (source_dir / "src/analysis/pair_verdict.hpp").read_text()
    source = (source_dir / "src/analysis/defects.cpp").read_text()
    failures = []
    wanted = []
    for name, before, after in MUTANTS:
        found = header.count(before) + source.count(before)
        if found == 1:
            wanted.append((name, header.replace(before, after), source.replace(before, after)))
        else:
            failures.append(f"'{before}' stands {found} times in pair_verdict.hpp and defects.cpp: mend this list")
    with tempfile.TemporaryDirectory() as scratch, ThreadPoolExecutor(os.cpu_count()) as pool:
        workshop = Workshop(source_dir, library, compiler, flags, pathlib.Path(scratch))
        right = pool.submit(workshop.run, "right", header, source)
        results = [(name, pool.submit(workshop.run, str(number), *texts)) for number, (name, *texts) in enumerate(wanted)]
        print("as it is:", right.result().stdout.strip())
        if right.result().returncode != 0:
            failures.append("the classifier itself disagrees with driving")
        for name, result in results:
            print(f"{name}: {result.result().stdout.strip()}")
            if result.result().returncode == 0:
                failures.append(f"not caught: {name}")
    for failure in failures:
        print("FAILED:", failure)
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
