"""Puts the tables of a result into docs/07-performance.md, between two marks."""
from pathlib import Path

import tables

BEGIN, END = "<!-- ./bench --docs writes from here -->", "<!-- to here -->"


def machine(result):
    m = result["machine"]
    return (f"{m['processor']}, {m['cores']} cores, {m['date']}; load when it began {m['load']:.1f}"
            f" ({'beside other work: wall times are noisy' if m['load'] > 0.5 else 'quiet'}); {result['command']}"
            + ("" if result.get("complete") else ", stopped before its end"))


def generated(result):
    return f"{BEGIN}\n{machine(result)}\n\n" + tables.report(result, tables.markdown_table, lambda t: f"**{t}**") + END


def insert(result, page: Path):
    text = page.read_text()
    before, _, rest = text.partition(BEGIN)
    inside, _, after = rest.partition(END)
    if not inside:
        raise SystemExit(f"{page} has no place for the tables: {BEGIN} ... {END}")
    page.write_text(before + generated(result) + after)
