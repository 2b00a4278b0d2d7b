#!/usr/bin/env python3
"""Breaks the code in named ways, one at a time, and shows that the tests notice.

usage: mutations.py [--only <part of a name>] [--jobs 2]
       mutations.py --check          only whether the code to break is there

Works on a copy of the last commit, in build_mutations/. Prints a row for each break: what it is, which test noticed. Exit
status 1 if none did, or if the code to break is no longer there."""
# SPDX-License-Identifier: BSD-3-Clause
import argparse
import os
import signal
import subprocess
import sys

from mutation_list import CORE, MUTATIONS, TILES

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
WORK = os.path.join(ROOT, "build_mutations")
SOURCE = os.path.join(WORK, "source")
BUILD = os.path.join(WORK, "build")
LIBRARY_TESTS = ["test_core", "test_filters", "test_features", "test_clouds"]


def call(words, **more):
    return subprocess.run(words, check=False, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, **more)


def prepare(jobs):
    os.makedirs(SOURCE, exist_ok=True)
    subprocess.run(f"git -C '{ROOT}' archive HEAD | tar -xm --overwrite -C '{SOURCE}'", shell=True, check=True)
    subprocess.run(["cmake", "-S", SOURCE, "-B", BUILD, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release",
                    "-DBUILD_EXAMPLES=OFF"], check=True, stdout=subprocess.DEVNULL)
    subprocess.run(["cmake", "--build", BUILD, "--parallel", jobs, "--target", *LIBRARY_TESTS, "test_tools",
                    "test_tiles"], check=True)


def failure_of(test, jobs):
    """Which test of a program fails, run in as many parallel parts as there are jobs; nothing if all pass."""
    program = os.path.join(BUILD, "test", "" if test in LIBRARY_TESTS else "tools", test)
    parts = [subprocess.Popen([program, "--gtest_brief=1", "--gtest_fail_fast"], stdout=subprocess.PIPE, text=True,
                              stderr=subprocess.DEVNULL, start_new_session=True,
                              env={**os.environ, "OMP_WAIT_POLICY": "passive", "GTEST_TOTAL_SHARDS": jobs,
                                   "GTEST_SHARD_INDEX": str(part)}) for part in range(int(jobs))]
    failure = None
    for part in parts:
        try:
            printed = part.communicate(timeout=1 if failure else 600)[0]
        except subprocess.TimeoutExpired:
            os.killpg(part.pid, signal.SIGKILL)
            part.communicate()
            failure = failure or f"{test}, which does not end"
            continue
        if part.returncode != 0 and not failure:
            failed = [line for line in printed.splitlines() if line.startswith("[  FAILED  ]")]
            failure = failed[0].split("] ")[1].split(",")[0].split(" (")[0] if failed else f"{test}, which crashes"
    return failure


def noticed_by(tests, jobs):
    """The first test that fails; nothing if all pass."""
    built = call(["cmake", "--build", BUILD, "--parallel", jobs, "--target", *tests])
    if built.returncode != 0:
        return "does not compile"
    return next(filter(None, (failure_of(test, jobs) for test in tests)), None)


def tests_for(file):
    """The tests, those that are likely to notice first."""
    if file.startswith(TILES):
        return ["test_tiles"]
    if file.startswith("tools/"):
        return ["test_tools"]
    return LIBRARY_TESTS if CORE in file else LIBRARY_TESTS[1:] + LIBRARY_TESTS[:1]


def try_out(mutation, jobs):
    name, file, old, new = mutation
    path = os.path.join(SOURCE, file)
    with open(path, encoding="utf-8") as source:
        text = source.read()
    if text.count(old) != 1:
        return f"stands {text.count(old)} times in {file}", False
    try:
        with open(path, "w", encoding="utf-8") as source:
            source.write(text.replace(old, new))
        found = noticed_by(tests_for(file), jobs)
    finally:
        with open(path, "w", encoding="utf-8") as source:
            source.write(text)
    return (found or "NOBODY"), bool(found) and found != "does not compile"


def check():
    """Checks that the code to break occurs where the list says, and only once in that file."""
    status = 0
    for name, file, old, _ in MUTATIONS:
        with open(os.path.join(ROOT, file), encoding="utf-8") as source:
            count = source.read().count(old)
            if count != 1:
                print(f"{name}: what it breaks stands {count} times in {file}")
                status = 1
    return status


def main():
    parser = argparse.ArgumentParser(description="Breaks the code in named ways and runs the tests.")
    parser.add_argument("--only", default="", help="part of the names of those to try")
    parser.add_argument("--jobs", default="2")
    parser.add_argument("--check", action="store_true", help="break nothing: is the code to break there?")
    arguments = parser.parse_args()
    if arguments.check:
        return check()
    prepare(arguments.jobs)
    chosen = [mutation for mutation in MUTATIONS if arguments.only in mutation[0]]
    caught = 0
    for mutation in chosen:
        found, good = try_out(mutation, arguments.jobs)
        caught += good
        print(f"| {mutation[0]} | {found} |", flush=True)
    print(f"{caught} of {len(chosen)} are noticed")
    return 0 if caught == len(chosen) else 1


if __name__ == "__main__":
    sys.exit(main())
