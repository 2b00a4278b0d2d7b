#!/usr/bin/env python3
"""Damages cloud and mesh files in many ways, and runs the tools on them.

usage: mutate_files.py <folder of the tools> [--count 5000] [--seed 1] [--keep <folder>]

Every run must end with status 0, 2 or 3 within 10 s and 1 GB of memory: never by a signal, never with a partial output
file. Exit status 1 if one does not; the files of such runs are kept."""
# SPDX-License-Identifier: BSD-3-Clause
import argparse
import collections
import math
import os
import pathlib
import random
import re
import resource
import shutil
import struct
import subprocess
import sys
import tempfile

SECONDS = 10
MEMORY = 1 << 30


def grid(side=14):
    """A noisy wave: points, and triangles between them."""
    noise = random.Random(5)
    points = [(x / 4, y / 4, math.sin(x / 4) / 2 + noise.uniform(-.02, .02)) for y in range(side) for x in range(side)]
    faces = [t for y in range(side - 1) for x in range(side - 1) for a in [y * side + x]
             for t in ((a, a + 1, a + side), (a + 1, a + side + 1, a + side))]
    return points, faces


def lines_of(rows):
    return "".join(" ".join(map(str, row)) + "\n" for row in rows).encode()


def pcd(encoding):
    points, _ = grid()
    header = ("# .PCD v0.7\nVERSION 0.7\nFIELDS x y z normal_x normal_y normal_z rgb\nSIZE 4 4 4 4 4 4 4\n"
              "TYPE F F F F F F U\nCOUNT 1 1 1 1 1 1 1\nWIDTH 14\nHEIGHT 14\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS 196\n"
              f"DATA {encoding}\n").encode()
    rows = [(*p, 0, 0, 1, 4278190335) for p in points]
    if encoding == "ascii":
        return header + lines_of(rows)
    if encoding == "binary":
        return header + b"".join(struct.pack("<6fI", *row) for row in rows)
    columns = b"".join(struct.pack("<I" if f == 6 else "<f", row[f]) for f in range(7) for row in rows)
    block = b"".join(bytes([len(columns[i:i + 32]) - 1]) + columns[i:i + 32] for i in range(0, len(columns), 32))
    return header + struct.pack("<II", len(block), len(columns)) + block  # LZF with literals only


def ply(encoding):
    points, faces = grid()
    header = (f"ply\nformat {encoding} 1.0\ncomment a wave\nelement vertex {len(points)}\nproperty float x\n"
              "property float y\nproperty float z\nproperty float nx\nproperty float ny\nproperty float nz\n"
              f"property uchar red\nproperty uchar green\nproperty uchar blue\nelement face {len(faces)}\n"
              "property list uchar int vertex_indices\nend_header\n").encode()
    if encoding == "ascii":
        return header + lines_of((*p, 0, 0, 1, 1, 2, 3) for p in points) + lines_of((3, *f) for f in faces)
    order = "<" if encoding == "binary_little_endian" else ">"
    return (header + b"".join(struct.pack(order + "6f3B", *p, 0, 0, 1, 1, 2, 3) for p in points) +
            b"".join(struct.pack(order + "B3i", 3, *f) for f in faces))


def off():
    points, faces = grid()
    return f"OFF\n{len(points)} {len(faces)} 0\n".encode() + lines_of(points) + lines_of((3, *f) for f in faces)


def obj():
    points, faces = grid()
    return lines_of(("v", *p) for p in points) + lines_of(("f", *(i + 1 for i in f)) for f in faces)


SEEDS = {"ascii.pcd": pcd("ascii"), "binary.pcd": pcd("binary"), "compressed.pcd": pcd("binary_compressed"),
         "ascii.ply": ply("ascii"), "little.ply": ply("binary_little_endian"), "big.ply": ply("binary_big_endian"),
         "mesh.off": off(), "mesh.obj": obj()}

HUGE = [b"-1", b"0", b"1", b"255", b"65536", b"2147483647", b"2147483648", b"4294967295", b"4294967296",
        b"268435456", b"1073741824", b"99999999999999999999", b"1e9", b"nan"]
ODD = [b"nan", b"inf", b"-inf", b"1e39", b"1e-45", b"0x1p3", b"three", b"--5", b"1e400", b"", b"\xff\xfe", b"1,5"]


def truncated(data, dice):
    return data[:dice.randrange(len(data))]


def lying_header(data, dice):
    """Replaces counts in the header: of widths, sizes, elements."""
    end = header_end(data)
    numbers = list(re.finditer(rb"(?<![\w.])\d+(?![\w.])", data[:end]))
    if not numbers:
        return data
    for chosen in dice.sample(numbers, min(len(numbers), dice.choice((1, 1, 2)))):
        data = data[:chosen.start()] + dice.choice(HUGE) + data[chosen.end():] if len(data) > chosen.end() else data
    return data


def consistent_lie(data, dice):
    """Makes all counts of a PCD file agree on points that are not there: up to 1 GB and beyond."""
    points = dice.choice((197, 70000, 38347922, 268435455, 4294967295))
    for key, value in ((b"WIDTH", points), (b"HEIGHT", 1), (b"POINTS", points), (b"element vertex", points)):
        data = re.sub(rb"(?m)^" + key + rb" \d+", key + b" %d" % value, data, count=1)
    return data


def header_end(data):
    found = re.search(rb"DATA \w+\n|end_header\n", data)
    return found.end() if found else min(len(data), 40)


def odd_text(data, dice):
    words = list(re.finditer(rb"\S+", data))
    if not words:
        return data
    for _ in range(dice.choice((1, 1, 3, 30))):
        word = dice.choice(words)
        if word.end() <= len(data):
            odd = dice.choice(ODD)
            data = data[:word.start()] + odd + data[word.end():]
    return data


def all_nan(data, dice):
    end = header_end(data)
    return data[:end] + re.sub(rb"-?\d{1,20}\.\d{1,20}", dice.choice((b"nan", b"inf", b"1e38", b"-1e-38")), data[end:])


def swapped_lines(data, dice):
    lines = data.split(b"\n")
    for _ in range(dice.choice((1, 2, 8))):
        i, j = dice.randrange(min(len(lines), 25)), dice.randrange(min(len(lines), 25))
        lines[i], lines[j] = lines[j], lines[i]
    return b"\n".join(lines)


def swapped_words(data, dice):
    lines = data.split(b"\n")
    line = dice.randrange(min(len(lines), 22))
    words = lines[line].split(b" ")
    dice.shuffle(words)
    lines[line] = b" ".join(words)
    return b"\n".join(lines)


def lost_line(data, dice):
    lines = data.split(b"\n")
    del lines[dice.randrange(min(len(lines), 25))]
    return b"\n".join(lines)


def twice(data, dice):
    lines = data.split(b"\n")
    line = dice.randrange(min(len(lines), 25))
    times = dice.choice((2, 3, 500)) if len(lines[line]) < 1000 else 2
    return b"\n".join(lines[:line] + [lines[line]] * times + lines[line:])


def zero_bytes(data, dice):
    begin = dice.randrange(len(data))
    length = dice.choice((1, 4, 64, 4096))
    return data[:begin] + bytes(min(length, len(data) - begin)) + data[begin + length:]


def random_bytes(data, dice):
    changed = bytearray(data)
    for _ in range(dice.choice((1, 2, 16, 200))):
        changed[dice.randrange(len(changed))] = dice.randrange(256)
    return bytes(changed)


def lost_bytes(data, dice):
    begin = dice.randrange(len(data))
    return data[:begin] + data[begin + dice.choice((1, 3, 17, 300)):]


def inserted_bytes(data, dice):
    begin = dice.randrange(len(data))
    return data[:begin] + bytes(dice.randrange(256) for _ in range(dice.choice((1, 3, 17)))) + data[begin:]


def type_lies(data, dice):
    for old, new in ((b" F", b" U"), (b"SIZE 4", b"SIZE 8"), (b"float", b"double"), (b"uchar", b"uint"),
                     (b"list uchar int", b"list uint int"), (b"binary", b"ascii"), (b"ascii", b"binary"),
                     (b"binary_little_endian", b"binary_big_endian"), (b"\n", b"\r\n")):
        if dice.random() < .25:
            data = data.replace(old, new, dice.choice((1, -1)))
    return data


def tail(data, dice):
    return data + dice.choice((b"garbage", bytes(100000), data, b"\n" * 5000))


def nothing(data, dice):
    return dice.choice((b"", b"\n", data[:1], bytes(1000), b" " * 1000))


def line_of_a_megabyte(data, dice):
    at = dice.randrange(len(data))
    return data[:at] + dice.choice((b"9", b" ", b"a", b"-")) * (1 << 20) + data[at:]


MUTATIONS = [truncated, lying_header, lying_header, lying_header, consistent_lie, odd_text, odd_text, all_nan,
             swapped_lines, swapped_words, lost_line, twice, zero_bytes, random_bytes, random_bytes, lost_bytes,
             inserted_bytes, type_lies, tail, nothing, line_of_a_megabyte]

CLOUD_COMMANDS = [command + ["-threads", "1"] for command in (
    ["pcl_normal_smoothing", "IN", "OUT"], ["pcl_normal_smoothing", "IN", "OUT", "-preset", "paper"],
    ["pcl_wpca_normal_estimation", "IN", "OUT"], ["pcl_hough_normal_estimation", "IN", "OUT"],
    ["pcl_bilateral_normal_filter", "IN", "OUT"], ["pcl_normal_guided_point_update", "IN", "OUT"],
    ["pcl_surface_noise_estimation", "IN"])]
MESH_COMMANDS = [["pcl_add_surface_noise", "IN", "OUT", "-seed", "1"],
                 ["pcl_smoothing_error", "IN", "GOOD", "-json", "1"]]


def limits():
    resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))


def is_complete(path):
    """Whether a PCD file holds as many bytes as its header says."""
    data = pathlib.Path(path).read_bytes()
    header = data[:header_end(data)].decode("latin1")
    lines = {line.split()[0]: line.split()[1:] for line in header.splitlines() if line.split()}
    stride = sum(int(s) * int(c) for s, c in zip(lines["SIZE"], lines["COUNT"]))
    return len(data) == len(header) + stride * int(lines["POINTS"][0])


def run(tools, command, folder, name):
    """What is wrong with how the tool ended; nothing if all is well."""
    output = os.path.join(folder, "out.pcd")
    places = {"IN": os.path.join(folder, name), "OUT": output, "GOOD": os.path.join(folder, "good.pcd")}
    words = [os.path.join(tools, command[0])] + [places.get(word, word) for word in command[1:]]
    before = set(os.listdir(folder))
    try:
        ended = subprocess.run(words, stdin=subprocess.DEVNULL, capture_output=True, timeout=SECONDS,
                               preexec_fn=limits, check=False)
    except subprocess.TimeoutExpired:
        for file in set(os.listdir(folder)) - before: # or the next run would take them for its own
            os.remove(os.path.join(folder, file))
        return None, f"took more than {SECONDS} s"
    left = set(os.listdir(folder)) - before
    if ended.returncode not in (0, 2, 3):
        return ended.returncode, f"ended with {ended.returncode}: {ended.stderr[-300:]!r}"
    if ended.returncode != 0 and not ended.stderr.strip():
        return ended.returncode, "says nothing"
    if left - ({"out.pcd"} if ended.returncode == 0 else set()):
        return ended.returncode, f"leaves {sorted(left)}"
    if "out.pcd" in left:
        if not is_complete(output):
            return ended.returncode, "leaves a partial output"
        os.remove(output)
    return ended.returncode, None


def main():
    parser = argparse.ArgumentParser(description="Runs the tools on damaged files.")
    parser.add_argument("tools", help="folder of the tools")
    parser.add_argument("--count", type=int, default=5000)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--keep", default="hostile_files_that_failed", help="folder for files that did harm")
    arguments = parser.parse_args()
    folder = tempfile.mkdtemp(prefix="hostile.")
    pathlib.Path(folder, "good.pcd").write_bytes(SEEDS["binary.pcd"])
    statuses, failures = collections.Counter(), 0
    for number in range(arguments.count):
        dice = random.Random(arguments.seed * 1000003 + number)
        seed = list(SEEDS)[number % len(SEEDS)]
        data, done = SEEDS[seed], []
        for _ in range(dice.choice((1, 1, 1, 2, 3))):
            mutation = dice.choice(MUTATIONS)
            done.append(mutation.__name__)
            data = (mutation(data, dice) if data else data)[:4 << 20]
        name = "in" + os.path.splitext(seed)[1]
        pathlib.Path(folder, name).write_bytes(data)
        is_cloud = not seed.startswith("mesh")
        command = dice.choice(CLOUD_COMMANDS if is_cloud and dice.random() < .8 or seed.endswith("pcd")
                              else MESH_COMMANDS)
        status, trouble = run(arguments.tools, command, folder, name)
        statuses[status] += 1
        if trouble:
            failures += 1
            os.makedirs(arguments.keep, exist_ok=True)
            kept = os.path.join(arguments.keep, f"{arguments.seed}_{number}_{name}")
            shutil.copy(os.path.join(folder, name), kept)
            print(f"{' '.join(command)} on {kept} ({seed}: {', '.join(done)}): {trouble}", flush=True)
        os.remove(os.path.join(folder, name))
    shutil.rmtree(folder)
    print(f"{arguments.count} damaged files: " +
          ", ".join(f"{n} ended with {s}" for s, n in sorted(statuses.items(), key=str)) + f"; {failures} failures")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
