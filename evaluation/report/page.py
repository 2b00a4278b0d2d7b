# SPDX-License-Identifier: BSD-3-Clause
"""One self-contained HTML page, which loads nothing else."""

import base64
import html
import io
import os

import PIL.Image

STYLE = """
:root { color-scheme: light; }
* { box-sizing: border-box; }
body { margin: 0; background: #fff; color: #1d1d1f; font: 16px/1.55 -apple-system, "Segoe UI", "Noto Sans", "DejaVu Sans", sans-serif; }
main { max-width: 1080px; margin: 0 auto; padding: 2.5rem 1.5rem 5rem; }
h1 { font-size: 2rem; line-height: 1.2; margin: 0 0 .4rem; }
h2 { font-size: 1.4rem; margin: 3.2rem 0 .6rem; padding-top: .8rem; border-top: 2px solid #1d1d1f; }
h3 { font-size: 1.08rem; margin: 2rem 0 .4rem; }
p, li { max-width: 74ch; }
a { color: #0059a8; }
.lead { color: #555; margin-top: 0; }
nav { background: #f5f5f7; border-radius: 8px; padding: .9rem 1.4rem; margin: 1.6rem 0; }
nav ol { margin: 0; padding-left: 1.3rem; columns: 2; column-gap: 3rem; }
nav li { break-inside: avoid; }
figure { margin: 1.4rem 0; }
figure img { max-width: 100%; height: auto; display: block; border: 1px solid #e6e6e6; border-radius: 4px; }
figcaption { color: #555; font-size: .9rem; margin-top: .45rem; max-width: 90ch; }
.scroll { overflow-x: auto; margin: 1rem 0; }
table { border-collapse: collapse; font-size: .86rem; line-height: 1.35; font-variant-numeric: tabular-nums; }
caption { text-align: left; color: #555; padding-bottom: .4rem; font-size: .9rem; }
th { text-align: left; border-bottom: 1.5px solid #1d1d1f; padding: .35rem .6rem; vertical-align: bottom; font-weight: 600; }
td { border-bottom: 1px solid #e6e6e6; padding: .28rem .6rem; vertical-align: top; }
td.n, th.n { text-align: right; white-space: nowrap; }
td.gap { color: #8a8a8a; font-style: italic; white-space: normal; }
tr.strong td { background: #fff4ec; }
tr.rule td { border-top: 1.5px solid #999; }
.gap-box { border: 1px dashed #b5b5b5; border-radius: 6px; padding: .7rem 1rem; color: #666; background: #fafafa; margin: 1rem 0; }
.verdict { border-left: 4px solid #999; padding: .35rem 0 .35rem .9rem; margin: .8rem 0; max-width: 82ch; }
.verdict b { margin-right: .3rem; }
.confirmed { border-color: #009e73; } .confirmed b { color: #00734f; }
.partly { border-color: #e69f00; } .partly b { color: #8a5f00; }
.not-confirmed { border-color: #d55e00; } .not-confirmed b { color: #a84600; }
code { background: #f2f2f4; padding: .08rem .3rem; border-radius: 3px; font-size: .9em; overflow-wrap: anywhere; }
@media (max-width: 700px) { nav ol { columns: 1; } }
@media print { main { max-width: none; } h2 { break-after: avoid; } figure, tr { break-inside: avoid; } }
"""


def escape(value):
    """Text from the data, escaped for HTML."""
    return html.escape(str(value))


def format_number(value, digits=3):
    """The value with the given number of significant digits, never in powers of ten; None stays None."""
    if value is None:
        return None
    if value == 0:
        return "0"
    text = f"{value:.{digits}g}"
    if "e" in text:
        text = f"{value:.0f}" if abs(value) >= 1 else f"{value:.6f}".rstrip("0").rstrip(".") or "0"
    return text


def embedded(path):
    """The picture as a data URI: large PNGs (above 400 kB) as JPEG, others as they are."""
    if path.endswith(".png") and os.path.getsize(path) > 400_000:
        buffer = io.BytesIO()
        PIL.Image.open(path).convert("RGB").save(buffer, "JPEG", quality=88, optimize=True)
        return "data:image/jpeg;base64," + base64.b64encode(buffer.getvalue()).decode()
    with open(path, "rb") as file:
        return "data:image/png;base64," + base64.b64encode(file.read()).decode()


VERDICTS = "<!-- verdicts -->"


class Gap(str):
    """A table cell without a value; its text gives the reason."""


class Page:
    """Collects sections in order, then writes the page."""

    def __init__(self, title, lead):
        self.title, self.lead = title, lead
        self.parts, self.contents, self.verdicts = [], [], []

    def section(self, name, title):
        self.contents.append((name, title))
        self.parts.append(f'<h2 id="{name}">{escape(title)}</h2>')

    def heading(self, title):
        self.parts.append(f"<h3>{escape(title)}</h3>")

    def text(self, text):
        """Adds HTML unchanged: text from the data must be escaped by the caller."""
        self.parts.append(f"<p>{text}</p>")

    def points(self, items):
        self.parts.append("<ul>" + "".join(f"<li>{item}</li>" for item in items) + "</ul>")

    def gap(self, what, why):
        self.parts.append(f'<div class="gap-box"><b>Gap: {escape(what)}.</b> {escape(why)}</div>')

    def verdict(self, verdict, text):
        self.verdicts.append((verdict, text))
        kind = verdict.split()[0] if verdict.startswith("partly") else verdict.replace(" ", "-")
        self.parts.append(f'<div class="verdict {kind}"><b>{escape(verdict.capitalize())}.</b> {escape(text)}</div>')

    def all_verdicts(self):
        """Inserts here a short list of all verdicts of the page, including those added later."""
        self.parts.append(VERDICTS)

    def figure(self, path, caption):
        alternative = escape(caption.split(".")[0])
        name = escape(os.path.basename(path))
        self.parts.append(
            f'<figure><img src="{embedded(path)}" alt="{alternative}"><figcaption>{escape(caption)} '
            f"<code>{name}</code></figcaption></figure>"
        )

    def table(self, header, rows, caption="", strong=(), rules=()):
        """Cells are texts, formatted numbers or Gaps. \\a strong and \\a rules are indices of rows."""
        numeric = [all(_looks_numeric(row[i]) for row in rows) for i in range(len(header))]
        parts = ['<div class="scroll"><table>']
        if caption:
            parts.append(f"<caption>{escape(caption)}</caption>")
        parts.append(
            "<thead><tr>" + "".join(_cell("th", text, numeric[i]) for i, text in enumerate(header)) + "</tr></thead><tbody>"
        )
        for index, row in enumerate(rows):
            kinds = [kind for kind, chosen in (("strong", strong), ("rule", rules)) if index in chosen]
            parts.append(f'<tr class="{" ".join(kinds)}">' if kinds else "<tr>")
            parts.append("".join(_cell("td", text, numeric[i]) for i, text in enumerate(row)) + "</tr>")
        self.parts.append("".join(parts) + "</tbody></table></div>")

    def write(self, path):
        """Writes the whole file or nothing: first beside the target, then renamed."""
        contents = "".join(f'<li><a href="#{name}">{escape(title)}</a></li>' for name, title in self.contents)
        verdicts = "".join(
            f"<li><b>{escape(verdict.capitalize())}</b>: {escape(text.split(': ')[0])}</li>"
            for verdict, text in self.verdicts
        )
        parts = [f"<ul>{verdicts}</ul>" if part == VERDICTS else part for part in self.parts]
        text = (
            f'<!DOCTYPE html>\n<html lang="en"><head><meta charset="utf-8"><title>{escape(self.title)}</title>'
            f'<meta name="viewport" content="width=device-width, initial-scale=1"><style>{STYLE}</style></head>\n'
            f'<body><main><h1>{escape(self.title)}</h1><p class="lead">{escape(self.lead)}</p>'
            f'<nav aria-label="Contents"><ol>{contents}</ol></nav>\n'
            + "\n".join(parts)
            + "\n</main></body></html>\n"
        )
        with open(path + ".part", "w", encoding="utf-8") as file:
            file.write(text)
        os.replace(path + ".part", path)


def _looks_numeric(cell):
    return isinstance(cell, Gap) or cell in (None, "") or str(cell)[:1] in "-+.0123456789"


def _cell(tag, text, is_number):
    if text is None:
        text = Gap("–")
    kinds = (["n"] if is_number else []) + (["gap"] if isinstance(text, Gap) else [])
    kind = f' class="{" ".join(kinds)}"' if kinds else ""
    return f"<{tag}{kind}>{escape(text)}</{tag}>"
