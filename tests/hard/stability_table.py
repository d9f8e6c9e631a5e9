#!/usr/bin/env python3
"""Writes the tables of docs/05-stability.md from what the hard cases measured: ctest -L hard leaves one file a case in
hard-cases/ of the build folder. With --check it changes nothing and fails where page and cases differ in name or story."""
import argparse
import json
import pathlib
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
BEGIN, END = "<!-- cases:{} -->", "<!-- end -->"


def cell(text):
    return text.replace("|", "\\|").replace("\n", " ")


def number(value):
    if value is None:  # JSON has no NaN
        return "not a number"
    if value == int(value) and abs(value) < 1e6:
        return str(int(value))
    return f"{value:.1e}"


def measure(m):
    bound = number(m["bound"])
    return f"{m['what']} {number(m['value'])}" + (f" (bound {bound})" if m["bound"] else "")


def story(row):
    return f"| `{row['case']}` | {cell(row['trouble'])} | {cell(row['remedy'])} |"


def told(measures):
    """Counts that are 0, as they must be, go without saying where there is anything else."""
    return [m for m in measures if m["value"] or m["bound"]] or measures


def table(rows):
    lines = ["| case | what goes wrong | what is done | measured |", "|---|---|---|---|"]
    lines += [f"{story(row)} {cell('; '.join(map(measure, told(row['measures']))))} |" for row in rows]
    return "\n".join(lines)


def sections(page):
    """The groups that the page has places for, in its order."""
    return [line[len("<!-- cases:"):-len(" -->")] for line in page.splitlines() if line.startswith("<!-- cases:")]


def filled(page, rows):
    for group in sections(page):
        begin = BEGIN.format(group)
        head, rest = page.split(begin, 1)
        _, tail = rest.split(END, 1)
        page = f"{head}{begin}\n{table([r for r in rows if r['group'] == group])}\n{END}{tail}"
    return page


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--build", type=pathlib.Path, default=ROOT / "build/release")
    parser.add_argument("--page", type=pathlib.Path, default=ROOT / "docs/05-stability.md")
    parser.add_argument("--check", action="store_true")
    options = parser.parse_args()
    rows = [json.loads(f.read_text()) for f in sorted((options.build / "hard-cases").glob("*.json"))]
    page = options.page.read_text()
    problems = [f"{r['case']} failed" for r in rows if not r["passed"]]
    problems += [f"{r['case']}: no place for group {r['group']}" for r in rows if r["group"] not in sections(page)]
    if options.check:
        problems += [f"{r['case']} does not stand in {options.page.name} as its test tells it" for r in rows
                     if story(r) not in page]
    elif not problems:
        options.page.write_text(filled(page, rows))
        print(f"{len(rows)} cases")
    print(*problems, sep="\n", file=sys.stderr)
    return 1 if problems or not rows else 0


if __name__ == "__main__":
    sys.exit(main())
