#!/usr/bin/env python3
"""Checks that the two pair loops of the engine keep their sums in registers.

    tools/check_pair_loops.py OBJECT ...

The OBJECTs are of a variant with 32 registers of the full width (avx512_16). In an innermost loop that takes
a square root, as each loop over a group's neighbours does, a sum may lie on the stack only if each neighbour adds to it
by one operation: by a chain of several, every neighbour waits for the way to memory and back as well. That took 9 % of
the speed once, without any change of the arithmetic (docs/decisions/060-the-engine-as-tables.md). What decides is the
order of the terms in sph_solver/pair_loops/right_hand_side.h and how far the distances run ahead (in_lanes.h). Exit
status: 0; 1: such a sum is on the stack, or a pair loop is not found; 2: wrong usage.
"""
import re
import subprocess
import sys

pair_loops = ("FirstPairLoop<true>", "FirstPairLoop<false>", "SecondPairLoop")


def functions_of(listing):
    """Name and instructions, (address, text), of each function."""
    for part in re.split(r"\n(?=[0-9a-f]{16} <)", listing):
        name, _, body = part.partition("\n")
        found = re.findall(r"^\s*([0-9a-f]+):\t(.*)$", body, re.MULTILINE)
        yield name, [(int(address, 16), text) for address, text in found]


def innermost_loops(code):
    """The instructions of each loop, from its first to the jump back, without another loop in it."""
    place = {address: k for k, (address, _) in enumerate(code)}
    jumps = [(re.match(r"j\w+\s+([0-9a-f]+)", text), k) for k, (_, text) in enumerate(code)]
    loops = [(place.get(int(jump.group(1), 16), k + 1), k) for jump, k in jumps if jump]
    loops = [(first, last) for first, last in loops if first <= last]
    for first, last in loops:
        if not any(first <= f and l < last for f, l in loops):
            yield [text for _, text in code[first : last + 1]]


def longest_chain(loop, slot):
    """Operations one after another from the load of a place of the stack to the store into it; 0: no sum of the loop."""
    since_load, chain = {}, 0
    for text in loop:
        name, _, rest = text.partition(" ")
        operands = re.findall(r"%\w+mm\d+|[-\w]*\([^)]*\)|[^,\s]+", rest)
        *sources, target = operands or [""]
        if name.startswith("vf"):
            sources.append(target)
        steps = [0 if source == slot else since_load.get(source) for source in sources]
        steps = [k for k in steps if k is not None]
        if target == slot:
            chain = max([chain, *steps])
        elif target.startswith("%"):
            since_load.pop(target, None)
            if steps:
                since_load[target] = max(steps) + (0 if name.startswith("vmov") else 1)
    return chain


def main():
    if len(sys.argv) < 2:
        print(__doc__, file=sys.stderr)
        return 2
    listing = subprocess.run(["objdump", "-d", "--no-show-raw-insn", "-C", *sys.argv[1:]],
                             capture_output=True, text=True, check=True).stdout
    status = 0
    functions = list(functions_of(listing))
    for pair_loop in pair_loops:
        loops = [loop for name, code in functions if f"::{pair_loop}, " in name
                 for loop in innermost_loops(code) if any("sqrtps" in text for text in loop)]
        chains = [0] + [longest_chain(loop, stored.group(1)) for loop in loops for text in loop
                        if (stored := re.match(r"vmov\S+\s+%\w+,(0x[0-9a-f]+\(%rsp\))", text))]
        status |= not loops or max(chains) > 1
        print(f"{pair_loop}: {len(loops)} loops, longest chain of a sum on the stack: {max(chains)} operations")
    return int(status)


sys.exit(main())
