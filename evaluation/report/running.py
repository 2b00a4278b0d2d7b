# SPDX-License-Identifier: BSD-3-Clause
"""Runs the project's tools."""

import os
import subprocess


class ToolTrouble(Exception):
    """A tool is missing or failed; the text gives the reason."""


def run(tools, name, *arguments):
    """Returns what the tool printed."""
    path = os.path.join(tools, name)
    if not os.access(path, os.X_OK):
        raise ToolTrouble(f"{name} is not built in {tools}: run evaluation/study.sh")
    try:
        done = subprocess.run([path, *map(str, arguments)], capture_output=True, text=True, timeout=300, check=False)
    except (OSError, subprocess.TimeoutExpired) as error:
        raise ToolTrouble(f"{name}: {error}") from error
    if done.returncode != 0:
        raise ToolTrouble((done.stderr.strip().splitlines() or [f"{name} ended with status {done.returncode}"])[-1])
    return done.stdout
