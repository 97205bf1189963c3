# SPDX-License-Identifier: LGPL-2.1-or-later
"""
Pages in one file: text, tables, pictures, films and charts to zoom into, for any browser and without a network.

What is shown is no matter of this module: softgrain.report fills a page from runs.
"""

import base64
import html
import json
import math
import mimetypes
import os
import pathlib

from .errors import InputError

HERE = pathlib.Path(__file__).resolve().parent
LIBRARY = "plotly-basic.min.js"
# Nothing but the page itself may be loaded, whatever it holds.
POLICY = ("default-src 'none'; img-src data: blob:; media-src data: blob:; style-src 'unsafe-inline'; "
          "script-src 'unsafe-inline'")


def library():
    """The text of the chart library: in the sources contrib/third-party, installed PREFIX/share/softgrain/third-party."""
    for folder in HERE.parents:
        for place in ("contrib/third-party", "share/softgrain/third-party"):
            path = folder / place / LIBRARY
            if path.is_file():
                return path.read_text(encoding="utf-8")
    raise InputError(f"{LIBRARY} is missing: it is installed with the program, in share/softgrain/third-party")


def escape(text):
    return html.escape(str(text))


def data_address(path):
    """
    A file as an address that holds it.

    >>> open("dot.gif", "wb").write(b"GIF89a") and data_address("dot.gif")
    'data:image/gif;base64,R0lGODlh'
    """
    kind = mimetypes.guess_type(path)[0] or "application/octet-stream"
    with open(path, "rb") as file:
        return f"data:{kind};base64,{base64.b64encode(file.read()).decode()}"


def plain(value):
    """
    Numbers and lists as JSON can hold them: what is no number is null.

    >>> import numpy as np
    >>> plain({"x": np.array([1.5, np.nan]), "n": np.int64(2)})
    {'x': [1.5, None], 'n': 2}
    """
    if isinstance(value, dict):
        return {key: plain(item) for key, item in value.items()}
    if isinstance(value, (list, tuple)):
        return [plain(item) for item in value]
    if hasattr(value, "tolist"):
        return plain(value.tolist())
    return None if isinstance(value, float) and not math.isfinite(value) else value


def json_within_page(data):
    """JSON that no browser takes for the end of the script that holds it."""
    return json.dumps(plain(data), ensure_ascii=False, allow_nan=False, separators=(",", ":")).replace("</", "<\\/")


class Section:
    """A part of a page with a heading."""

    def __init__(self, page, heading):
        self.page, self.heading, self.parts = page, heading, []
        self.name = heading.lower().replace(" ", "-")

    def add(self, code):
        """HTML as it is."""
        self.parts.append(code)

    def text(self, words):
        self.add(f"<p>{escape(words)}</p>")

    def warnings(self, lines):
        """Lines (colour, name, text) that nobody is to overlook."""
        if lines:
            self.add('<ul class="warnings">' + "".join(f"<li>{chip(colour, name)} {escape(text)}</li>"
                                                       for colour, name, text in lines) + "</ul>")

    def table(self, head, rows, classes="", search=False):
        """
        @head: HTML of the columns; @rows: (name, cells, classes), or (name,) for a line between groups. With @search a
        field above it shows the rows that have what is typed.
        """
        cells = "".join(f"<th>{cell}</th>" for cell in head)
        lines = []
        for row in rows:
            if len(row) == 1:
                lines.append(f'<tr class="group"><th colspan="{len(head)}">{escape(row[0])}</th></tr>')
            else:
                values = "".join(f"<td>{escape(cell)}</td>" for cell in row[1])
                lines.append(f'<tr class="{row[2]}"><th>{escape(row[0])}</th>{values}</tr>')
        tools = '<input type="search" placeholder="find" aria-label="find in this table">' if search else ""
        self.add(f'<div class="table {classes}">{tools}<div class="scroll"><table><thead><tr>{cells}</tr></thead>'
                 f'<tbody>{"".join(lines)}</tbody></table></div></div>')

    def figures(self, items):
        """Pictures and films side by side: (address, caption), the address from data_address()."""
        self.add('<div class="figures">' + "".join(figure(address, caption) for address, caption in items) + "</div>")

    def curves(self, heading, series, x, y, **options):
        """
        Columns of the page's tables as curves. @series: {name, tables, colour, dash, y} with tables in the order in which
        the columns are looked for, and y left out where the reader chooses it. @x and @y: lists of columns; of several the
        reader chooses. Options: logx, logy, wide, height, markers, follow (the choice of x for all
        curves counts here, too).
        """
        self.chart({"heading": heading, "series": series, "x": x, "y": y, **options})

    def traces(self, heading, traces, layout, **options):
        """A chart in the words of the library."""
        self.chart({"heading": heading, "traces": traces, "layout": layout, **options})

    def chart(self, chart):
        number = len(self.page.charts)
        self.page.charts.append(chart)
        wide = " wide" if chart.get("wide") else ""
        height = f' style="height:{chart["height"]}px"' if "height" in chart else ""
        self.add(f'<figure class="chart{wide}"><h3>{chart["heading"]}</h3><div class="tools" id="tools-{number}"></div>'
                 f'<div class="plot" id="chart-{number}"{height}></div></figure>')

    def html(self):
        # Charts that follow each other share a grid.
        code, inside = [], False
        for part in self.parts:
            chart = part.startswith('<figure class="chart')
            if chart != inside:
                code.append('<div class="charts">' if chart else "</div>")
                inside = chart
            code.append(part)
        return f'<section id="{self.name}"><h2>{escape(self.heading)}</h2>{"".join(code)}{"</div>" if inside else ""}</section>'


def chip(colour, name):
    """A name with the colour that its curves have."""
    return f'<span class="chip"><i style="background:{escape(colour)}"></i>{escape(name)}</span>'


def figure(address, caption):
    shown = f'<video controls loop muted playsinline preload="metadata" src="{address}"></video>' \
        if address.startswith("data:video/") else f'<img src="{address}" alt="{escape(caption)}">'
    return f"<figure>{shown}<figcaption>{escape(caption)}</figcaption></figure>"


class Page:
    """
    A page with its sections and the tables that its curves show.

    >>> page = Page("A page")
    >>> page.tables["run"] = {"time_s": [0., 1.], "force_N_per_m": [0., 2.]}
    >>> page.section("Curves").curves("Force", [{"name": "run", "tables": ["run"]}], ["time_s"], ["force_N_per_m"])
    >>> read_data(page.html())["tables"]["run"]["force_N_per_m"]
    [0.0, 2.0]
    """

    def __init__(self, title, lead=""):
        self.title, self.lead = title, lead
        self.sections, self.charts, self.tables, self.columns = [], [], {}, {}
        self.foot = ""

    def section(self, heading):
        self.sections.append(Section(self, heading))
        return self.sections[-1]

    def html(self):
        """The whole page."""
        data = {"tables": self.tables, "columns": self.columns, "charts": self.charts}
        links = "".join(f'<a href="#{one.name}">{escape(one.heading)}</a>' for one in self.sections)
        style, program = ((HERE / f"page.{ending}").read_text(encoding="utf-8") for ending in ("css", "js"))
        return (f'<!DOCTYPE html>\n<html lang="en"><head><meta charset="utf-8">'
                f'<meta http-equiv="Content-Security-Policy" content="{POLICY}">'
                f'<meta name="viewport" content="width=device-width, initial-scale=1"><title>{escape(self.title)}</title>'
                f"<style>\n{style}</style></head>\n<body><header><h1>{escape(self.title)}</h1>"
                f'<div class="lead">{self.lead}</div></header><nav>{links}</nav><main><div id="problem" hidden></div>\n' +
                "\n".join(one.html() for one in self.sections) +
                f"\n</main><footer>{escape(self.foot)}</footer>\n"
                f'<script type="application/json" id="data">{json_within_page(data)}</script>\n'
                f"<script>{library()}</script>\n<script>\n{program}</script></body></html>\n")

    def write(self, path):
        """Writes the page whole or not at all."""
        folder, name = os.path.split(path)
        if folder:
            os.makedirs(folder, exist_ok=True)
        temporary = os.path.join(folder, ".part-" + name)
        with open(temporary, "w", encoding="utf-8") as file:
            file.write(self.html())
        os.replace(temporary, path)


def read_data(text):
    """The data within a page, as a program may want them: tables, columns, charts."""
    begin = text.index('id="data">') + len('id="data">')
    return json.loads(text[begin:text.index("</script>", begin)])
