#!/usr/bin/python3
"""Checks that the wide kernels leak nothing into the rest of the program.

An inline function or template that a file compiled with -mavx2 or -mavx512 does not inline becomes a weak symbol, and
the linker may take that copy for the whole program, which then dies on a machine without these instructions. So every
weak symbol in a …kernel_avx2.o must carry the name of its own namespace, isa_avx2, and so on (src/core/pack.hpp).

usage: kernel_symbols.py LIBRARY.a
"""

import re
import subprocess
import sys

KERNEL = re.compile(r"^(?:\w+_)?kernel_(avx\w*)\.cpp\.o:$")
WEAK = re.compile(r"^[0-9a-f]+ [WVu] (?!DW\.ref\.)(.+)$")


def leaks(listing):
    """(instruction set, symbol) of every weak symbol that nm lists in a wide kernel, outside of its own namespace."""
    kernel = None
    for line in listing.splitlines():
        if line.endswith(":"):
            kernel = KERNEL.match(line)
        elif kernel and (symbol := WEAK.match(line)) and f"isa_{kernel[1]}::" not in symbol[1]:
            yield kernel[1], symbol[1]


def main(arguments):
    if len(arguments) != 1:
        print(__doc__, file=sys.stderr)
        return 2
    command = ["nm", "--demangle", "--defined-only", arguments[0]]
    found = list(leaks(subprocess.run(command, check=True, capture_output=True, text=True).stdout))
    for kernel, symbol in found:
        print(f"kernel_{kernel}.cpp leaks {symbol}, which others may then call where {kernel} is missing")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
