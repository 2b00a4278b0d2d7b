# SPDX-License-Identifier: BSD-3-Clause
"""Passes clouds and meshes back and forth between this project's tools and CloudCompare, MeshLab and Open3D.

usage: interchange.py <folder of the tools>        exit status 0 if all is as expected"""

import os
import subprocess
import sys
import tempfile

import numpy
import open3d

# Which of all fields the other programs keep: CloudCompare's command line takes the scalars whose names it knows (its
# window asks about the rest) and packs normals into 21 bits; meshlabserver has one scalar, and reads an intensity as
# grey in place of the colours, so it is given a cloud without.
ALL = {"normals", "colors", "intensity", "scalar_height", "quality", "label"}
EXPECTED = {"CloudCompare": {"normals", "colors", "intensity", "scalar_height"}, "MeshLab": {"normals", "colors", "quality"},
            "Open3D": ALL}  # fmt: skip
NORMAL_ERROR = {"CloudCompare": 0.005}
SIDE = 40
failures = []


def run(*words):
    """Runs a program and returns what it printed. A failure ends this script."""
    done = subprocess.run(list(map(str, words)), capture_output=True, text=True, timeout=300, check=False)
    if done.returncode != 0:
        sys.exit(f"{' '.join(map(str, words))}: status {done.returncode}\n{done.stdout}{done.stderr}")
    return done.stdout


def check(what, problem):
    print(f"| {what} | {problem or 'yes'} |", flush=True)
    if problem:
        failures.append(what)


def write_input(path, without=()):
    """A noisy plane with every kind of field, as text."""
    count = SIDE * SIDE
    random = numpy.random.default_rng(1)
    names = [("float", name) for name in ("x", "y", "z", "nx", "ny", "nz")]
    names += [("uchar", name) for name in ("red", "green", "blue")]
    scalars = {"quality": lambda i, z: i / count, "intensity": lambda i, z: i / 7, "scalar_height": lambda i, z: z}
    scalars = {name: value for name, value in scalars.items() if name not in without}
    names += [("float", name) for name in scalars] + [("int", "label")]
    with open(path, "w", encoding="ascii") as file:
        file.write(f"ply\nformat ascii 1.0\nelement vertex {count}\n")
        file.writelines(f"property {kind} {name}\n" for kind, name in names)
        file.write("end_header\n")
        for i, z in enumerate(random.normal(0, 0.01, count)):
            file.write(f"{i % SIDE * 0.05:g} {i // SIDE * 0.05:g} {z:g} 0 0 1 {i % 256} {3 * i % 256} {7 * i % 256} ")
            file.write("".join(f"{value(i, z):g} " for value in scalars.values()) + f"{i % 5}\n")


def attributes(path):
    """An array per attribute, by name, including positions. Read by Open3D, which takes all of them."""
    cloud = open3d.t.io.read_point_cloud(path)
    return {name: cloud.point[name].numpy() for name in cloud.point}


def difference(expected, got, names, normal_error=1e-4):
    """What is wrong with the attributes that should be there, or None. Programs have their own names for a scalar."""
    if len(got.get("positions", ())) != len(expected["positions"]):
        return f"{len(got.get('positions', ()))} points of {len(expected['positions'])}"
    for name in ["positions", *sorted(names)]:
        values = next((got[key] for key in (name, f"scalar_{name}", f"scalar_{name}".replace("scalar_scalar", "scalar"))
                       if key in got), None)  # fmt: skip
        if values is None:
            return f"{name} is missing"
        error = normal_error if name == "normals" else 1e-4
        if not numpy.allclose(values[:, :3].astype(float), expected[name].astype(float), atol=error):
            return f"{name} is another"
    return None


def by_cloudcompare(source, target, *options):
    run("CloudCompare", "-SILENT", "-AUTO_SAVE", "OFF", "-O", source, "-C_EXPORT_FMT", "PLY", *options, "-SAVE_CLOUDS", "FILE",
        target)  # fmt: skip


def by_meshlab(source, target, *_):
    # Quality, normals and colours of the vertices.
    run("meshlabserver", "-i", source, "-o", target, "-m", "vq", "vn", "vc")


def by_open3d(source, target, *_):
    cloud = open3d.t.io.read_point_cloud(source)
    if not open3d.t.io.write_point_cloud(target, cloud, write_ascii="ascii" in target, compressed="compressed" in target):
        sys.exit(f"Open3D cannot write {target}")


PROGRAMS = {
    "CloudCompare": (by_cloudcompare, [("ascii.ply", "-PLY_EXPORT_FMT", "ASCII"), ("binary.ply", "-PLY_EXPORT_FMT",
                                                                                    "BINARY_LE")]),
    "MeshLab": (by_meshlab, [("binary.ply",)]),
    "Open3D": (by_open3d, [("ascii.ply",), ("binary.ply",), ("ascii.pcd",), ("binary.pcd",), ("compressed.pcd",)]),
}  # fmt: skip


def check_outputs(tools, folder):
    """Returns the files that each program wrote."""
    written = {name: [] for name in PROGRAMS}
    for extension, kinds in (("ply", ("ascii", "binary")), ("pcd", ("ascii", "binary", "compressed"))):
        for kind in kinds:
            ours = os.path.join(folder, f"ours_{kind}.{extension}")
            grey = os.path.join(folder, f"grey_{kind}.{extension}")
            for target, without in ((grey, ("intensity",)), (ours, ())):
                source = os.path.join(folder, "source.ply")
                write_input(source, without)
                run(f"{tools}/pcl_normal_smoothing", source, target, "-format", kind)
            expected = attributes(ours)
            missing = (ALL | {"positions"}) - set(expected)
            check(f"{extension.upper()} {kind} opens in Open3D", f"without {missing}" if missing else None)
            for name, (convert, formats) in PROGRAMS.items():
                if extension == "pcd" and name != "Open3D":  # Debian's CloudCompare and MeshLab have no PCD
                    continue
                for number, (form, *options) in enumerate(formats):
                    theirs = os.path.join(folder, f"{name}_{kind}_{extension}_{form}")
                    convert(grey if name == "MeshLab" else ours, theirs, *options)
                    problem = difference(expected, attributes(theirs), EXPECTED[name], NORMAL_ERROR.get(name, 1e-4))
                    if number == 0 or problem:
                        what = ", ".join(sorted(EXPECTED[name]))
                        check(f"{extension.upper()} {kind} through {name}: positions, {what}", problem)
                    written[name].append(theirs)
    return written


def check_inputs(tools, written, folder):
    """Each tool must read what the programs wrote without losing anything."""
    commands = [("pcl_normal_smoothing",), ("pcl_wpca_normal_estimation",), ("pcl_hough_normal_estimation",),
                ("pcl_bilateral_normal_filter",), ("pcl_normal_guided_point_update",)]  # fmt: skip
    for name, files in written.items():
        problem = None
        for theirs in files:
            before = attributes(theirs)
            for (tool,) in commands:
                ours = os.path.join(folder, "read" + os.path.splitext(theirs)[1])
                run(f"{tools}/{tool}", theirs, ours)
                after = attributes(ours)
                kept = [key for key in before if key not in ("positions", "normals")]
                lost = [key for key in kept if key not in after or not (after[key] == before[key]).all()]
                if lost or len(after["positions"]) != SIDE * SIDE:
                    problem = f"{tool} loses {lost} of {os.path.basename(theirs)}"
            run(f"{tools}/pcl_surface_noise_estimation", theirs)
        if os.access(f"{tools}/pcl_normal_smoothing_viewer", os.X_OK):
            run(f"{tools}/pcl_normal_smoothing_viewer", files[0], "-screenshot", os.path.join(folder, "seen.png"))
        check(f"{len(files)} clouds of {name}, read by every tool, with all fields", problem)


def check_meshes(tools, folder):
    """The tools that take meshes must read those of the programs."""
    torus = os.path.join(folder, "torus.ply")
    run(f"{tools}/pcl_make_double_torus", torus)
    meshes = {"CloudCompare": [], "MeshLab": [], "Open3D": []}
    for extension in ("ply", "obj", "off", "stl"):
        for name in meshes:
            target = os.path.join(folder, f"{name}_mesh.{extension}")
            if name == "CloudCompare":
                run("CloudCompare", "-SILENT", "-AUTO_SAVE", "OFF", "-O", torus, "-M_EXPORT_FMT", extension.upper(),
                    "-SAVE_MESHES", "FILE", target)  # fmt: skip
            elif name == "MeshLab":
                run("meshlabserver", "-i", torus, "-o", target)
            else:
                mesh = open3d.io.read_triangle_mesh(torus)
                mesh.compute_triangle_normals()
                open3d.io.write_triangle_mesh(target, mesh)
            meshes[name].append(target)
    for name, files in meshes.items():
        for mesh in files:
            noisy = os.path.join(folder, "noisy.ply")
            run(f"{tools}/pcl_add_surface_noise", mesh, noisy, "-sigma", 0.2)
            run(f"{tools}/pcl_smoothing_error", mesh, noisy)
        check(f"PLY, OBJ, OFF and STL meshes of {name}, read by the tools that take meshes", None)


def main():
    tools = sys.argv[1]
    with tempfile.TemporaryDirectory() as folder:
        print("| | |\n|---|---|")
        check_inputs(tools, check_outputs(tools, folder), folder)
        check_meshes(tools, folder)
    sys.exit(f"{len(failures)} are not as expected" if failures else 0)


if __name__ == "__main__":
    main()
