# SPDX-License-Identifier: BSD-3-Clause
"""Makes <study folder>/report/index.html, one self-contained page, with each figure as PNG and SVG beside it."""

import argparse
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


def make(study, folder, tools, scan):
    """The page, complete; what cannot be drawn is a gap with its reason."""
    page = Page("Smoothing study", overview.lead(study))
    progress("tables and plots")
    overview.add(study, page)
    main_results.add(study, page, folder)
    pictures.add(study, page, folder, tools, scan, progress)
    paper_figures.add(study, page, folder)
    table1.add(study, page)
    honesty.add(study, page, folder)
    overview.add_gaps(study, page)
    return page


def main():
    options = arguments()
    if not os.path.isdir(options.study):
        print(f"make_report.py: {options.study} is no folder: give the one that pcl_smoothing_study wrote", file=sys.stderr)
        return 2
    began = time.monotonic()
    folder = os.path.join(options.study, "report")
    try:
        os.makedirs(folder, exist_ok=True)
        page = make(Study(options.study), folder, options.tools, options.scan)
        path = os.path.join(folder, "index.html")
        page.write(path)
    except OSError as error:
        print(f"make_report.py: cannot write the report: {error}", file=sys.stderr)
        return 2
    progress(f"done in {time.monotonic() - began:.0f} s")
    print(path)
    return 0


if __name__ == "__main__":
    sys.exit(main())
