# SPDX-License-Identifier: BSD-3-Clause
"""All renderings of the page. If something cannot be rendered, there is a gap with the reason."""

from off_screen import NoDisplay, display


def add(study, page, folder, tools, scan, progress, why_none=""):
    """\a why_none: the reason, if it is already known that nothing can be rendered."""
    page.section("pictures", "Pictures: Figs. 1, 4 and 5")
    if why_none:
        page.gap("all renderings", why_none)
        return
    try:
        import flips
        import gallery
        import scans
        import scene
        import sheets
    except ImportError as error:
        page.gap("all renderings", f"{error}: run evaluation/install_report.sh")
        return
    try:
        with display(), scene.Stage() as stage:
            gallery.add(study, page, folder, stage, progress)
            page.section("details", "Pictures: Figs. 3, 9 and 10")
            progress("normals, scan, sheets")
            flips.add(study, page, folder, stage, tools)
            scans.add(page, folder, stage, tools, scan)
            sheets.add(study, page, folder, tools)
    except NoDisplay as error:
        page.gap("all renderings", str(error))
