# SPDX-License-Identifier: BSD-3-Clause
"""Makes <study folder>/report/index.html, one self-contained page, with each figure as PNG and SVG beside it."""

import argparse
import multiprocessing
import os
import sys
import time

import honesty
import main_results
import overview
import paper_figures
import pictures
import table1
from page import Page
from study import Study

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))


def arguments():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("study", help="folder that pcl_smoothing_study wrote")
    parser.add_argument("-scan", help="a real scan, PCD or PLY, for Fig. 9")
    parser.add_argument(
        "-tools", default=os.path.join(ROOT, "build", "tools"), help="folder of the built tools, for Figs. 3 and 9"
    )
    return parser.parse_args()


def progress(text):
    print(f"report: {text}", file=sys.stderr, flush=True)


def make(study, folder, tools, scan, why_no_pictures=""):
    """Builds the complete page; what cannot be drawn is a gap with its reason."""
    page = Page("Smoothing study", overview.lead(study))
    progress("tables and plots")
    overview.add(study, page)
    main_results.add(study, page, folder)
    pictures.add(study, page, folder, tools, scan, progress, why_no_pictures)
    paper_figures.add(study, page, folder)
    table1.add(study, page)
    honesty.add(study, page, folder)
    overview.add_gaps(study, page)
    return page


def make_and_write(options, why_no_pictures=""):
    """Exits with status 2 if the report cannot be written."""
    folder = os.path.join(options.study, "report")
    try:
        os.makedirs(folder, exist_ok=True)
        page = make(Study(options.study), folder, options.tools, options.scan, why_no_pictures)
        page.write(os.path.join(folder, "index.html"))
    except OSError as error:
        print(f"make_report.py: cannot write the report: {error}", file=sys.stderr)
        sys.exit(2)


def run(*arguments):
    """Makes the report in a child process, as graphics drivers may crash without an exception. Returns its status."""
    process = multiprocessing.get_context("fork").Process(target=make_and_write, args=arguments)
    process.start()
    process.join()
    return process.exitcode


def main():
    options = arguments()
    if not os.path.isdir(options.study):
        print(f"make_report.py: {options.study} is no folder: give the one that pcl_smoothing_study wrote", file=sys.stderr)
        return 2
    began = time.monotonic()
    status = run(options)
    if status < 0:
        progress(f"the renderer crashed (signal {-status}): once more without it")
        status = run(options, f"the renderer crashed (signal {-status})")
    if status == 0:
        progress(f"done in {time.monotonic() - began:.0f} s")
        print(os.path.join(options.study, "report", "index.html"))
    return status if status >= 0 else 3


if __name__ == "__main__":
    sys.exit(main())
