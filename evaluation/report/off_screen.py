# SPDX-License-Identifier: BSD-3-Clause
"""A display for VTK on machines without one."""

import contextlib
import os
import select
import shutil
import subprocess


class NoDisplay(Exception):
    """Nothing can be rendered; the text gives the reason."""


@contextlib.contextmanager
def display():
    """Runs an X server of our own during the block, even if there is a display: its pictures are the same on every machine."""
    if not shutil.which("Xvfb"):
        raise NoDisplay("Xvfb is not installed: run evaluation/install_report.sh")
    reading, writing = os.pipe()
    server = subprocess.Popen(
        ["Xvfb", "-displayfd", str(writing), "-screen", "0", "1280x1024x24", "-nolisten", "tcp"],
        pass_fds=[writing], stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
    )  # fmt: skip
    os.close(writing)
    before = os.environ.get("DISPLAY")
    try:
        ready, _, _ = select.select([reading], [], [], 30)
        number = os.read(reading, 16).decode().strip() if ready else ""
        if not number:
            raise NoDisplay("Xvfb did not start")
        os.environ["DISPLAY"] = f":{number}"
        yield
    finally:
        os.close(reading)
        server.terminate()
        server.wait()
        if before is None:
            os.environ.pop("DISPLAY", None)
        else:
            os.environ["DISPLAY"] = before
