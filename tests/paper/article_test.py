#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The article: its numbers are references to stored files and lead somewhere, and nothing else in it is a number. Usage: article_test.py"""
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
ARTICLE = ROOT / "paper/article"
sys.path.insert(0, str(ARTICLE))
sys.dont_write_bytecode = True
try:
    import stored
    import tables
except ModuleNotFoundError as missing:
    print(f"skipped: {missing}")
    sys.exit(77)

TEXT = (ARTICLE / "article.tex").read_text(encoding="utf-8")


def fill(text):
    return stored.filled(text, "a.tex", tables.FUNCTIONS)


class References(unittest.TestCase):
    def test_every_reference_of_the_article_leads_to_a_stored_value(self):
        text = stored.filled(TEXT, "paper/article/article.tex", tables.FUNCTIONS)
        self.assertGreater(len(stored.REFERENCE.findall(TEXT)), 80)
        self.assertNotIn("<<", text)
        self.assertNotRegex(text, r"\b(nan|inf|None)\b")

    def test_no_number_in_the_article_is_anything_but_a_reference(self):
        self.assertEqual(stored.bare_numbers(TEXT), [])

    def test_a_reference_that_leads_nowhere_is_named_with_file_line_and_key(self):
        for reference, reason in (("paper/none.json: a", "no such file"), ("paper/orders.json: none", "no 'none' there"),
                                  ("paper/orders.json: orders[case=none].value", "0 elements fit, not one"),
                                  ("paper/orders.json: orders[case=slab_cosine].value", "2 elements fit, not one"),
                                  ("paper/orders.json: orders[9999].value", "of 63 elements"),
                                  ("paper/orders.json: study[0]", "of what is no list"),
                                  ("paper/orders.json: study", "is text"), ("paper/orders.json: quick", "is no number"),
                                  ("paper/orders.json: study | date", "is no date"),
                                  ("paper/orders.json: provenance | count", "is no list"),
                                  ("derived: none", "no such function"), ("README.md: a", "neither .json nor .toml")):
            with self.assertRaises(stored.Unknown) as raised:
                fill(f"first line\nthe second <<{reference}>>")
            self.assertIn(f"a.tex:2: <<{reference}>>: ", str(raised.exception))
            self.assertIn(reason.replace("63", str(len(stored.get("paper/orders.json", "orders")))), str(raised.exception))

    def test_a_value_that_is_no_number_cannot_be_shown(self):
        for value in (None, float("nan"), float("inf")):
            with self.assertRaises(stored.Unknown):
                stored.shown(value)

    def test_numbers_are_shown_with_the_digits_that_are_asked_for(self):
        self.assertEqual(stored.formatted(0.4654762, ".2f"), "0.47")
        self.assertEqual(stored.formatted(0.4654762, ".0f%"), r"47\,\%")
        self.assertEqual(stored.formatted(0.0196, "*10000 .0f"), "196")
        self.assertEqual(stored.formatted(2.69e11, ""), r"$2.69\times10^{11}$")
        self.assertEqual(stored.formatted(1e-12, ".1g"), "$10^{-12}$")
        self.assertEqual(stored.formatted(210.0, ".2g"), "210")
        self.assertEqual(stored.formatted(-1.5, ""), "$-$1.5")
        self.assertEqual(stored.formatted([1, 2], "count"), "2")

    def test_numbers_in_a_text_are_found_wherever_they_stand(self):
        for text in ("a loaf of 2.5 kg", "twice in 20 s", r"$\beta=100$", "37 claims", r"\paper{2.5}", r"\textbf{12}", "x 1e-5",
                     "25\\,\\%"):
            self.assertEqual(len(stored.bare_numbers("first line\n" + text)), 1, text)
            self.assertEqual(stored.bare_numbers("first line\n" + text)[0][0], 2, text)

    def test_references_places_names_quotes_and_indices_are_no_bare_numbers(self):
        for text in ("<<paper/orders.json: orders[0].value | .2f>>", r"\paper{figure~15}", r"\paper{(Eq.~19)}", r"\name{Debian~12}",
                     r"\cite{ding19}",
                     r"\quoted{the paper}{48 threads}", r"$\theta_0$ and $x^2$", "% 12 in a comment", r"\photo{loaf2.png}{0.5}"):
            self.assertEqual(stored.bare_numbers(text), [], text)

    def test_symbols_of_plain_texts_are_set_as_symbols(self):
        self.assertEqual(stored.escaped("theta_out - 5 %"), r"$\theta_{\mathrm{out}}$ $-$ 5\,\%")
        self.assertEqual(stored.escaped("apple_limp >= q^2"), r"apple\_limp $\ge$ q\textsuperscript{2}")
        self.assertEqual(stored.code("a_b"), r"\code{a\_b}")

    def test_every_function_of_the_tables_is_named_in_the_article(self):
        for kind, functions in tables.FUNCTIONS.items():
            for name in functions:
                self.assertIn(f"<<{kind}: {name}>>", TEXT)


class Kept(unittest.TestCase):
    def test_every_kept_folder_is_that_of_an_item_at_a_quality(self):
        names = {item["name"] for item in stored.read("paper/items.toml")["item"]}
        folders = sorted(p.name for p in (ROOT / tables.FIGURES).iterdir())
        self.assertTrue(folders)
        for folder in folders:
            name, quality = folder.rsplit("-", 1)
            self.assertIn(name, names)
            self.assertIn(quality, tables.QUALITIES)
            result = stored.read(f"{tables.FIGURES}/{folder}/claims.json")
            self.assertEqual((result["name"], result["quality"]), (name, quality), folder)
            self.assertTrue(result["claims"], folder)

    def test_kept_claims_that_were_rewritten_since_are_marked(self):
        item = next(i for i in stored.read("paper/items.toml")["item"] if i["name"] == "bread")
        result = tables.kept("bread")
        self.assertFalse(tables.is_outdated(item, result))
        self.assertTrue(tables.is_outdated(item, {**result, "claims": [c for c in result["claims"] if c["metric"] != "crack_share"]}))

    def test_pictures_and_charts_of_the_article_are_there(self):
        shown = [("docs/pictures/", name) for name in re.findall(r"\\photo\{(.*?)\}", TEXT)]
        shown += [("paper/", name) for name in re.findall(r"\\chart\{(.*?)\}", TEXT)]
        self.assertGreater(len(shown), 10)
        for folder, name in shown:
            self.assertTrue((ROOT / folder / name).is_file(), name)

    def test_every_kept_chart_is_shown(self):
        for chart in (ROOT / tables.FIGURES).glob("*/*.pdf"):
            self.assertIn(chart.relative_to(ROOT / "paper").as_posix(), TEXT)


class Replication(unittest.TestCase):
    def test_every_item_has_a_script_without_parameters_and_no_other_is_there(self):
        expected = {"install.sh": "table 2"}
        for item in stored.read("paper/items.toml")["item"]:
            kind, number = item["number"].split()
            name = f"figure_{int(number):02}" if kind == "figure" else f"{kind}_{number}"
            expected[name + ".sh"] = f"figure {item['name']}" if kind == "experiment" else item["number"]
        scripts = {p.name: p for p in (ROOT / "replicate").glob("*.sh")}
        self.assertEqual(sorted(scripts), sorted(expected))
        for name, script in scripts.items():
            last = script.read_text(encoding="utf-8").splitlines()[-1]
            self.assertEqual(last, f'exec "$(dirname -- "${{BASH_SOURCE[0]}}")/../bake" {expected[name]}')
            self.assertTrue(os.access(script, os.X_OK), name)

    def test_the_citation_names_the_version_of_the_project(self):
        version = re.search(r"project\(.*?VERSION\s+([\d.]+)", (ROOT / "CMakeLists.txt").read_text(encoding="utf-8"), re.DOTALL)[1]
        self.assertEqual(stored.get("CITATION.cff", "version"), version)


@unittest.skipUnless(shutil.which("pdflatex"), "no pdflatex")
class Page(unittest.TestCase):
    def test_the_same_files_give_the_same_article_and_no_line_runs_out_of_the_page(self):
        pages = []
        with tempfile.TemporaryDirectory() as folder:
            for name in "ab":
                done = subprocess.run([sys.executable, ARTICLE / "make_article.py", "--out", pathlib.Path(folder, name)], check=False,
                                      stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
                self.assertEqual(done.returncode, 0, done.stdout)
                pages.append(pathlib.Path(folder, name, "article.pdf").read_bytes())
                log = pathlib.Path(folder, name, "article.log").read_text(encoding="utf-8", errors="replace")
                self.assertEqual([width for width in re.findall(r"Overfull \\hbox \(([\d.]+)pt", log) if float(width) > 2], [])
        self.assertEqual(pages[0], pages[1])


if __name__ == "__main__":
    unittest.main()
