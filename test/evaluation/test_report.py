# SPDX-License-Identifier: BSD-3-Clause
"""Tests of the study's report, on studies with known numbers.
usage: test_report.py <source folder of the project> [folder of the built tools] [pcl_smoothing_study]"""

import csv
import html
import os
import re
import subprocess
import sys
import tempfile
import unittest

SOURCE = os.path.abspath(sys.argv[1])
TOOLS = os.path.abspath(sys.argv[2]) if len(sys.argv) > 2 else "no tools"
STUDY = os.path.abspath(sys.argv[3]) if len(sys.argv) > 3 else None
REPORT = os.path.join(SOURCE, "evaluation", "report")
sys.path[:0] = [REPORT, os.path.dirname(os.path.abspath(__file__))]
try:
    import matplotlib  # noqa: F401
    import PIL  # noqa: F401
except ImportError as error:
    print(f"skipped: {error}: run evaluation/install_report.sh")
    sys.exit(77)

import claims  # noqa: E402
import gallery  # noqa: E402
import geometry  # noqa: E402
import honesty  # noqa: E402
import report_fixture as fixture  # noqa: E402
import summary  # noqa: E402
import table1  # noqa: E402
from page import format_number  # noqa: E402
from study import Study, geometric_mean  # noqa: E402

SECTIONS = "summary run results pictures figures table1 honesty gaps".split()


def make_page(folder):
    """Runs the report. Returns the page as HTML and as text."""
    done = subprocess.run(
        [sys.executable, os.path.join(REPORT, "make_report.py"), folder, "-tools", TOOLS],
        capture_output=True,
        text=True,
        check=False,
    )
    if done.returncode != 0:
        raise AssertionError(done.stderr)
    with open(os.path.join(folder, "report", "index.html"), encoding="utf-8") as file:
        page = file.read()
    text = re.sub(r"<style>.*?</style>", "", page, flags=re.S)
    return page, html.unescape(re.sub(r"<[^>]+>", " ", text))


class Fixture(unittest.TestCase):
    @unittest.skipUnless(STUDY, "the study is not built")
    def test_has_the_columns_of_the_study(self):
        with tempfile.TemporaryDirectory() as folder:
            missing = os.path.join(folder, "missing.ply")  # a failed row is enough to get the columns
            words = [STUDY, folder, missing, "-models", "none", "-peers", "0", "-sweep", "0", "-noise", "GN", "-seeds", "1"]
            subprocess.run(words, capture_output=True, check=True)
            with open(os.path.join(folder, "rows.csv"), newline="", encoding="utf-8") as file:
                self.assertEqual(next(csv.reader(file)), fixture.HEADER)


class PrintedTable(unittest.TestCase):
    def setUp(self):
        self.rows = table1.printed_rows()

    def test_has_five_models_two_noises_five_methods(self):
        keys = [(row["model"], row["noise"], row["method"]) for row in self.rows]
        self.assertEqual(len(set(keys)), 50)
        self.assertEqual([{key[i] for key in keys} for i in (1, 2)], [{"GN", "GR"}, set(table1.METHODS)])
        self.assertEqual(
            {(r["model"], r["points"]) for r in self.rows},
            {("double_torus", 4350), ("elephant", 24955), ("fandisk", 25894), ("nicolo", 25239), ("femur", 8168)},
        )

    def test_errors_are_in_the_printed_range(self):
        area = [float(row["E_A_1e-3"]) for row in self.rows]
        curvature = [float(row["E_k_1e-3"]) for row in self.rows]
        self.assertEqual((min(area), max(area)), (0.02, 141.30))
        self.assertEqual((min(curvature), max(curvature)), (0.05, 0.78))
        # The sums of the printed columns reveal typing errors.
        self.assertAlmostEqual(sum(area), 834.11, places=2)
        self.assertAlmostEqual(sum(curvature), 11.12, places=2)

    def test_parameters_have_the_methods_form(self):
        for row in self.rows:
            form = r"W?[PH][TGM]U(7|15|21), \d+, \d+" if row["method"] == "Ours" else r"[\d.]+, [\d.]+"
            self.assertRegex(row["parameters"], f"^{form}$")


class Numbers(unittest.TestCase):
    def test_no_powers_of_ten(self):
        self.assertEqual(
            [format_number(v) for v in (None, 0, 0.27149, 52.225, 123456.0, 0.00001234)],
            [None, "0", "0.271", "52.2", "123456", "0.000012"],
        )

    def test_means_leave_out_what_is_missing(self):
        self.assertAlmostEqual(geometric_mean([0.5, None, 2.0]), 1)
        self.assertIsNone(geometric_mean([None]))

    def test_rank_correlation(self):
        self.assertAlmostEqual(honesty.rank_correlation([1, 2, 3, 4], [1, 4, 9, 16]), 1)
        self.assertAlmostEqual(honesty.rank_correlation([1, 2, 3], [3, 2, 1]), -1)
        self.assertAlmostEqual(honesty.rank_correlation([1, 1, 2, 2], [1, 2, 1, 2]), 0)
        self.assertIsNone(honesty.rank_correlation([1, 2], [1, 2]))


class Geometry(unittest.TestCase):
    def test_distances_to_a_plane(self):
        plane = geometry.surface([[0, 0, 0], [4, 0, 0], [0, 4, 0]], geometry.numpy.array([[0, 1, 2]]))
        found = geometry.distances(geometry.numpy.array([[1.0, 1, 0.5], [1, 1, -2], [1, 1, 0]]), plane)
        geometry.numpy.testing.assert_allclose(found, [0.5, 2, 0], atol=1e-7)

    def test_surface_variation(self):
        grid = geometry.numpy.array([[x, y, 0.0] for x in range(6) for y in range(6)])
        geometry.numpy.testing.assert_allclose(geometry.surface_variation(grid), 0, atol=1e-12)
        cube = geometry.numpy.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0.0, 1)])
        geometry.numpy.testing.assert_allclose(geometry.surface_variation(cube, 8), 1 / 3)


class Verdicts(unittest.TestCase):
    def sweep(self, area=lambda *_: 1.0, curvature=lambda *_: 1.0):
        rows = fixture.sweep("double_torus", "GN", area, curvature, lambda *_: 1.0)
        return rows

    def test_area_follows_the_rows(self):
        low = self.sweep(area=lambda e, w, k, n, p: 1 if e != "WP" and k != 21 else 2)
        self.assertEqual(claims.area_by_estimator(low, "m", "GN")[0], claims.CONFIRMED)
        high = self.sweep(area=lambda e, w, k, n, p: 2 if e != "WP" and k != 21 else 1)
        self.assertEqual(claims.area_by_estimator(high, "m", "GN")[0], claims.NOT_CONFIRMED)
        self.assertEqual(claims.area_by_estimator(low[:100], "m", "GN")[0], claims.UNTOLD)

    def test_curvature_follows_the_rows(self):
        for best, noise in ((("P", 15), "GN"), (("WP", 7), "GR")):
            rows = self.sweep(curvature=lambda e, w, k, n, p, best=best: 1 if (e, k) == best else 2)
            self.assertEqual(claims.curvature_by_estimator(rows, "m", noise)[0], claims.CONFIRMED)
            other = "GR" if noise == "GN" else "GN"
            self.assertNotEqual(claims.curvature_by_estimator(rows, "m", other)[0], claims.CONFIRMED)

    def test_rimls(self):
        ours, rimls = {"E_A": 1.0, "E_k15": 1.0}, {"E_A": 2.0, "E_k15": 2.0}
        self.assertEqual(claims.competitive_with_rimls([(ours, rimls)])[0], claims.CONFIRMED)
        self.assertEqual(claims.competitive_with_rimls([(rimls, ours)])[0], claims.NOT_CONFIRMED)
        self.assertEqual(claims.competitive_with_rimls([])[0], claims.UNTOLD)


class WholePage(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        fixture.write_study(cls.folder.name, fixture.typical_rows(cls.folder.name))
        cls.page, cls.text = make_page(cls.folder.name)

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def test_has_every_section_and_a_table_of_contents(self):
        for name in SECTIONS:
            self.assertIn(f'<h2 id="{name}">', self.page)
            self.assertIn(f'href="#{name}"', self.page)
        for figure in ("Fig. 1", "Fig. 3", "Fig. 6", "Fig. 7", "Fig. 8", "Fig. 9", "Fig. 10"):
            self.assertIn(figure, self.text)

    def test_loads_nothing(self):
        self.assertEqual(re.findall(r'(?:src|href)="(?!data:|#)[^"]*"', self.page), [])
        self.assertNotIn("url(", self.page)
        self.assertNotIn("<script", self.page)

    def test_figures_lie_beside_it(self):
        files = os.listdir(os.path.join(self.folder.name, "report"))
        for name in ("results_GN_0.2", "results_GR_0.2", "fig6_GN", "fig7", "fig8", "area_course"):
            self.assertTrue({name + ".png", name + ".svg"} <= set(files), name)

    def test_numbers_are_those_of_the_rows(self):
        with open(os.path.join(self.folder.name, "rows.csv"), newline="", encoding="utf-8") as file:
            rows = [row for row in csv.DictReader(file) if row["noise"] == "GN" and row["status"] == "ok"]
        for preset in ("default", "fast", "paper"):
            values = [float(row["p2s_ratio"]) for row in rows if row["family"] == "ours" and row["name"] == preset]
            cell = f"{sum(values) / 2:.3f} ± {(max(values) - min(values)) / 2:.3f}"
            self.assertRegex(self.page, f"<td>ours: {preset}</td><td[^>]*>{cell}</td>")
        sweep = [float(row["p2s_ratio"]) for row in rows if row["family"] == "sweep"]
        for which, value in (("best", min(sweep)), ("mean", sum(sweep) / len(sweep)), ("worst", max(sweep))):
            self.assertRegex(self.page, f"<td>paper&#x27;s 540: {which}</td><td[^>]*>{value:.3f}</td>")
        exact = [float(row["exact_ratio"]) for row in rows if row["name"] == "default"]
        in_row = f"<td>ours: default</td>(?:(?!</tr>).)*<td[^>]*>{format_number(sum(exact) / 2)}</td>"
        self.assertRegex(self.page, in_row)
        rimls = [float(row["p2s_ratio"]) for row in rows if row["name"] == "RIMLS"]
        self.assertRegex(self.page, f"<td>RIMLS: best</td><td[^>]*>{min(rimls):.3f}</td>")

    def test_table_holds_printed_and_measured(self):
        line = re.search(
            r"double torus\s+GN\s+Ours\s+\(PTU7, 32, 5\)\s+0\.59\s+0\.31\s+(\w+), (\d+), (\d+)\s+([\d.]+)", self.text
        )
        self.assertIsNotNone(line)
        self.assertEqual(line.groups(), ("PTU15", "2", "5", format_number(1e3 * (1e-3 + 5e-6))))

    def test_gaps_say_why(self):
        self.assertIn("timed out after 7 s <&>", self.text)
        self.assertIn("meshlabserver is not installed", self.text)
        self.assertIn("Gap: Fig. 6, GR", self.text)
        self.assertIn("Gap: Fig. 9", self.text)
        self.assertIn("Gap: Fig. 10", self.text)

    def test_verdicts_are_computed(self):
        self.assertRegex(self.text, r"Confirmed\.\s+Curvature error is lowest with PCA k 15 \(double torus, GN\)")
        self.assertRegex(self.text, r"Confirmed\.\s+Thresholded weights have the lowest area error, over all models \(GN\)")
        self.assertRegex(
            self.text, r"Cannot be told\.\s+Thresholded weights have the lowest area error, over all models \(GR\)"
        )


class PoorStudies(unittest.TestCase):
    def page_of(self, write):
        with tempfile.TemporaryDirectory() as folder:
            write(folder)
            return make_page(folder)

    def test_empty_folder(self):
        page, text = self.page_of(lambda folder: None)
        for name in SECTIONS:
            self.assertIn(f'<h2 id="{name}">', page)
        self.assertIn("rows.csv cannot be read", text)

    def test_header_alone(self):
        _, text = self.page_of(lambda folder: fixture.write_study(folder, []))
        self.assertIn("the study has no finished row", text)

    def test_killed_in_the_middle_of_a_line(self):
        def write(folder):
            fixture.write_study(folder, fixture.typical_rows(folder)[:6])
            with open(os.path.join(folder, "rows.csv"), "a", encoding="utf-8") as file:
                file.write("double_torus,81,GN,0.2,1,ours,fa")
            os.remove(os.path.join(folder, "clouds", "case", "noisy.ply"))

        _, text = self.page_of(write)
        self.assertIn("1 damaged line(s) of rows.csv are left out", text)
        self.assertIn("0.281 ± 0.010", text)

    def test_best_setting_is_chosen_by_the_first_seed(self):
        with tempfile.TemporaryDirectory() as folder:
            rows = [
                fixture.row("m", "GN", "peer", "RIMLS", seed, parameters="a", p2s_ratio=r)
                for seed, r in ((1, 0.5), (2, 0.9))
            ]
            rows.append(fixture.row("m", "GN", "peer", "RIMLS", parameters="b", p2s_ratio=0.6))
            fixture.write_study(folder, rows, ["m"])
            best = summary.peer_entries(Study(folder), "RIMLS", model="m", noise="GN")[1]
            self.assertEqual((best.setting, best.seeds), ("a", 2))
            self.assertAlmostEqual(best.mean(), 0.7)

    def test_a_default_alone_is_not_called_the_best(self):
        with tempfile.TemporaryDirectory() as folder:
            alone = fixture.row("m", "GN", "peer", "RIMLS", parameters="a (default)", p2s_ratio=0.5)
            fixture.write_study(folder, [alone], ["m"])
            study = Study(folder)
            default, best = summary.peer_entries(study, "RIMLS", model="m", noise="GN")
            self.assertAlmostEqual(default.mean(), 0.5)
            self.assertIsNone(best.mean())
            self.assertEqual(best.reason, "only the default was tried")
            titles = [title for title, _, _ in gallery.shown_rows(study, "m", "GN")]
            self.assertIn("RIMLS, default", titles)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=2)
