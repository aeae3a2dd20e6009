#!/usr/bin/env python3
"""Mutation test of the classifier: every wrong sign must be caught.

Builds classifier_check.cpp with copies of src/analysis/defects.cpp and pair_verdict.hpp in which one thing is wrong. The
right source must agree with driving everywhere, each mutant must not.

usage: classifier_mutants.py SOURCE_DIR LIBRARY CXX [FLAG...]   (linker flags among them)
"""

import pathlib
import subprocess
import sys
import tempfile

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
    ("sense of the drive exchanged", "driver.wide & ccw_bit", "driver.wide & cw_bit"),
]


def build_and_run(source_dir, library, compiler, flags, header, source, folder):
    (folder / "analysis").mkdir(parents=True)
    (folder / "analysis" / "pair_verdict.hpp").write_text(header)
    (folder / "defects.cpp").write_text(source)
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
    source = (source_dir / "src/analysis/defects.cpp").read_text()
    failures = []
    with tempfile.TemporaryDirectory() as scratch:
        run = lambda name, *texts: build_and_run(source_dir, library, compiler, flags, *texts, pathlib.Path(scratch) / name)
        right = run("right", header, source)
        print("as it is:", right.stdout.strip())
        if right.returncode != 0:
            failures.append("the classifier itself disagrees with driving")
        for number, (name, before, after) in enumerate(MUTANTS):
            found = header.count(before) + source.count(before)
            if found != 1:
                failures.append(f"'{before}' stands {found} times in pair_verdict.hpp and defects.cpp: mend this list")
                continue
            result = run(str(number), header.replace(before, after), source.replace(before, after))
            print(f"{name}: {result.stdout.strip()}")
            if result.returncode == 0:
                failures.append(f"not caught: {name}")
    for failure in failures:
        print("FAILED:", failure)
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
