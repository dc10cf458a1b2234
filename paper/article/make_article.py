#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Fills the references of article.tex from stored files and sets it. Usage: make_article.py [--out FOLDER] [--tex-only]

The same files give the same PDF, bit for bit. Exit codes as of ./bake: 2 for a reference that leads nowhere or wrong use, 3 if LaTeX fails.
"""
import argparse
import calendar
import os
import pathlib
import subprocess
import sys
import time

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE))
import stored  # noqa: E402
import tables  # noqa: E402


def fail(code, message):
    print(f"bake: {message}", file=sys.stderr)
    sys.exit(code)


def set_pdf(folder):
    """Runs LaTeX three times: twice without pictures, until its own references are settled."""
    day = calendar.timegm(time.strptime(tables.newest_day(), "%Y-%m-%d"))
    environment = dict(os.environ, SOURCE_DATE_EPOCH=str(day), FORCE_SOURCE_DATE="1", TEXINPUTS=f".:{stored.ROOT}:",
                       max_print_line="1000")
    for mode in (["-draftmode"], ["-draftmode"], []):
        done = subprocess.run(["pdflatex", *mode, "-interaction=nonstopmode", "-halt-on-error", "article.tex"], cwd=folder, env=environment,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False)
        log = (folder / "article.log").read_text(encoding="utf-8", errors="replace") if (folder / "article.log").is_file() else ""
        if done.returncode != 0:
            wrong = [line for line in log.splitlines() if line.startswith("!") or line.startswith("l.")]
            fail(3, f"LaTeX failed: {' '.join(wrong[:2]) or 'no message'}; its log is {folder / 'article.log'}")
    if "undefined" in log or "Rerun to get" in log:
        fail(3, f"a reference within the article is undefined; see {folder / 'article.log'}")


def main():
    parser = argparse.ArgumentParser(prog="bake paper",
                                     description="Sets the reproduction report from stored results, without any simulation.")
    parser.add_argument("--out", metavar="FOLDER", default="results/paper", type=pathlib.Path, help="where to write it (results/paper)")
    parser.add_argument("--tex-only", action="store_true", help="write the text with its numbers, article.tex, and no PDF")
    arguments = parser.parse_args()
    folder = arguments.out.resolve()
    try:
        text = stored.filled((HERE / "article.tex").read_text(encoding="utf-8"), "paper/article/article.tex", tables.FUNCTIONS)
        folder.mkdir(parents=True, exist_ok=True)
        (folder / "article.tex").write_text(text, encoding="utf-8")
        if arguments.tex_only:
            print(arguments.out / "article.tex")
            return
        set_pdf(folder)
    except stored.Unknown as error:
        fail(2, str(error))
    except OSError as error:
        fail(2, f"{error.filename}: {error.strerror}")
    print(arguments.out / "article.pdf")


if __name__ == "__main__":
    main()
