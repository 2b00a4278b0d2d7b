#!/usr/bin/env python3
"""Prints what the program stages wrote (--benchmark_out) as a table. usage: stage_table.py stages.json"""
# SPDX-License-Identifier: BSD-3-Clause
import json
import re
import sys


def row(benchmark):
    name, points, k, threads = re.match(r"(.*)/points:(\d+)/k:(\d+)/threads:(\d+)", benchmark["name"]).groups()
    def number(counter):
        return f"{float(f'{benchmark[counter]:.3g}'):g}" if counter in benchmark else ""
    bandwidth = f"{benchmark['bytes_per_second'] / 1e9:.3g}" if "bytes_per_second" in benchmark else ""
    return [name, points, k, threads, number("ns/point"), number("ns/edge/core"), bandwidth]


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    with open(sys.argv[1], encoding="utf-8") as file:
        benchmarks = json.load(file)["benchmarks"]
    print("| stage | points | k | threads | ns a point | ns an edge and core | GB/s |\n" + "|---" * 7 + "|")
    for benchmark in benchmarks:
        print("| " + " | ".join(row(benchmark)) + " |")


if __name__ == "__main__":
    main()
