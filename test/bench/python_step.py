#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""What a time step costs in Python beside the same steps in one call of the engine: python_step.py [PAIRS]

The target is 1.2 of the engine's time step and 2 us. Needs the package in PYTHONPATH. Processor time of the thread,
in pairs that are run in turns, because the machine does other work.
"""

import statistics
import sys
import time

import perilymph

TICKS = 2000


def duration_us(move):
    began = time.thread_time()
    move()
    return 1e6 * (time.thread_time() - began) / TICKS


def one_by_one(insertion):
    advance = insertion.advance
    for _ in range(TICKS):
        advance(2.0).force_axial_N


def main(pairs=30):
    insertion = perilymph.Insertion("contour-published")
    insertion.advance(2.0, ticks=4000)  # 8 mm deep: many contacts
    start = insertion.snapshot()
    together, apart = [], []
    for _ in range(pairs):
        for kept, move in ((together, lambda: insertion.advance(2.0, ticks=TICKS)), (apart, lambda: one_by_one(insertion))):
            insertion.restore(start)
            kept.append(duration_us(move))
    engine, step = statistics.median(together), statistics.median(apart)
    over = statistics.median(b - a for a, b in zip(together, apart))
    print(f"engine {engine:.1f} us, Python {step:.1f} us a time step, {over:+.2f} us more (median of pairs); "
          f"least {min(together):.1f} and {min(apart):.1f} us; target {1.2 * engine + 2:.1f} us")


if __name__ == "__main__":
    main(*map(int, sys.argv[1:]))
