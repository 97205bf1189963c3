# SPDX-License-Identifier: LGPL-2.1-or-later
"""
Pages in one file: text, tables, pictures, films and charts to zoom into, for any browser and
without a network.

What is shown is no matter of this module: softgrain.report fills a page from runs.
"""

import base64
import html
import json
import math
import mimetypes
import os
import pathlib
import re

from .errors import InputError

HERE = pathlib.Path(__file__).resolve().parent
LIBRARY = "plotly-basic.min.js"
# Nothing but the page itself may be loaded, whatever it holds.
POLICY = (
    "default-src 'none'; img-src data: blob:; media-src data: blob:; style-src 'unsafe-inline'; "
    "script-src 'unsafe-inline'"
)


def library():
    """
    The text of the chart library: in the sources contrib/third-party, installed
    PREFIX/share/softgrain/third-party, of a wheel the same in the package.
    """
    for folder in (HERE / "program", *HERE.parents):
        for place in ("contrib/third-party", "share/softgrain/third-party"):
            path = folder / place / LIBRARY
            if path.is_file():
                return path.read_text(encoding="utf-8")
    raise InputError(
        f"{LIBRARY} is missing: it is installed with the program, in share/softgrain/third-party"
    )


class Markup(str):
    """
    Text that is HTML already. Whatever becomes part of a page and is not of this kind is escaped,
    so that nothing that a run or a study says can become an element.
    """


def escape(text):
    """
    Text as HTML shows it; Markup as it is.

    >>> escape("a < b"), escape(Markup("<b>"))
    ('a &lt; b', '<b>')
    """
    return text if isinstance(text, Markup) else Markup(html.escape(str(text)))


def tag(name, *content, **attributes):
    """
    An element; `class_` stands for class, as no name of Python's may be that.

    >>> tag("b", "a < b", tag("i", "c"), class_='"')
    '<b class="&quot;">a &lt; b<i>c</i></b>'
    """
    words = "".join(
        f' {key.rstrip("_").replace("_", "-")}="{escape(value)}"'
        for key, value in attributes.items()
    )
    return Markup(f"<{name}{words}>{''.join(map(escape, content))}</{name}>")


def joined(parts, between=""):
    """Parts of a page, one after the other."""
    return Markup(escape(between).join(map(escape, parts)))


def slug(text):
    """
    A name for an address within the page.

    >>> slug("Error against cost"), slug('"><script>')
    ('error-against-cost', 'script')
    """
    return re.sub(r"[^a-z0-9]+", "-", text.lower()).strip("-")


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
    """
    JSON without a sign that means something to HTML: no browser sees an end of the script, or a
    comment, in it.
    """
    text = json.dumps(plain(data), ensure_ascii=False, allow_nan=False, separators=(",", ":"))
    for sign in "<>&\u2028\u2029":
        text = text.replace(sign, f"\\u{ord(sign):04x}")
    return text


class Section:
    """A part of a page with a heading."""

    def __init__(self, page, heading):
        self.page, self.heading, self.parts = page, heading, []
        self.name = slug(heading)

    def add(self, code):
        """An element as tag() makes it; plain text is escaped."""
        self.parts.append(escape(code))

    def text(self, words):
        self.add(tag("p", words))

    def warnings(self, lines):
        """Lines (colour, name, text) that nobody is to overlook."""
        if lines:
            self.add(
                tag(
                    "ul",
                    *(tag("li", chip(colour, name), " ", text) for colour, name, text in lines),
                    class_="warnings",
                )
            )

    def table(self, head, rows, classes="", search=False):
        """
        @head: names of the columns, or elements; @rows: (name, cells, classes), or (name,) for a
        line between groups. With @search a field above it shows the rows that have what is typed.
        """
        lines = []
        for row in rows:
            if len(row) == 1:
                lines.append(tag("tr", tag("th", row[0], colspan=len(head)), class_="group"))
            else:
                lines.append(
                    tag(
                        "tr",
                        tag("th", row[0]),
                        *(tag("td", cell) for cell in row[1]),
                        class_=row[2],
                    )
                )
        tools = Markup(
            '<input type="search" placeholder="find" aria-label="find in this table">'
            if search
            else ""
        )
        top = tag("thead", tag("tr", *(tag("th", cell) for cell in head)))
        self.add(
            tag(
                "div",
                tools,
                tag("div", tag("table", top, tag("tbody", *lines)), class_="scroll"),
                class_=f"table {classes}",
            )
        )

    def figures(self, items):
        """Pictures and films side by side: (address, caption), the address from data_address()."""
        self.add(
            tag("div", *(figure(address, caption) for address, caption in items), class_="figures")
        )

    def curves(self, heading, series, x, y, **options):
        """
        Columns of the page's tables as curves. @series: {name, tables, colour, dash, y} with tables
        in the order in which the columns are looked for, and y left out where the reader chooses
        it. @x and @y: lists of columns; of several the reader chooses. Options: logx, logy, wide,
        height, markers, follow (the choice of x for all curves counts here, too).
        """
        self.chart({"heading": heading, "series": series, "x": x, "y": y, **options})

    def traces(self, heading, traces, layout, **options):
        """A chart in the words of the library."""
        self.chart({"heading": heading, "traces": traces, "layout": layout, **options})

    def chart(self, chart):
        number = len(self.page.charts)
        self.page.charts.append(chart)
        height = {"style": f"height:{chart['height']:g}px"} if "height" in chart else {}
        self.add(
            tag(
                "figure",
                tag("h3", chart["heading"]),
                tag("div", class_="tools", id=f"tools-{number}"),
                tag("div", class_="plot", id=f"chart-{number}", **height),
                class_="chart wide" if chart.get("wide") else "chart",
            )
        )

    def html(self):
        # Charts that follow each other share a grid.
        code, inside = [], False
        for part in self.parts:
            chart = part.startswith('<figure class="chart')
            if chart != inside:
                code.append('<div class="charts">' if chart else "</div>")
                inside = chart
            code.append(part)
        return tag(
            "section",
            tag("h2", self.heading),
            Markup("".join(code) + ("</div>" if inside else "")),
            id=self.name,
        )


def chip(colour, name):
    """A name with the colour that its curves have."""
    return tag("span", tag("i", style=f"background:{colour}"), name, class_="chip")


def figure(address, caption):
    shown = (
        '<video controls loop muted playsinline preload="metadata"'
        f' src="{escape(address)}"></video>'
        if address.startswith("data:video/")
        else f'<img src="{escape(address)}" alt="{escape(caption)}">'
    )
    return tag("figure", Markup(shown), tag("figcaption", caption))


class Page:
    """
    A page with its sections and the tables that its curves show.

    >>> page = Page("A page")
    >>> page.tables["run"] = {"time_s": [0., 1.], "force_N_per_m": [0., 2.]}
    >>> runs = [{"name": "run", "tables": ["run"]}]
    >>> page.section("Curves").curves("Force", runs, ["time_s"], ["force_N_per_m"])
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
        links = joined(tag("a", one.heading, href="#" + one.name) for one in self.sections)
        style, program = (
            (HERE / f"page.{ending}").read_text(encoding="utf-8") for ending in ("css", "js")
        )
        return (
            '<!DOCTYPE html>\n<html lang="en"><head><meta charset="utf-8">'
            f'<meta http-equiv="Content-Security-Policy" content="{POLICY}">'
            '<meta name="viewport" content="width=device-width, initial-scale=1">'
            f"<title>{escape(self.title)}</title><style>\n{style}</style></head>\n"
            f"<body><header><h1>{escape(self.title)}</h1>"
            f'{tag("div", self.lead, class_="lead")}</header><nav>{links}</nav><main>'
            '<div id="problem" hidden></div>\n'
            + "\n".join(one.html() for one in self.sections)
            + f"\n</main><footer>{escape(self.foot)}</footer>\n"
            f'<script type="application/json" id="data">{json_within_page(data)}</script>\n'
            f"<script>{library()}</script>\n<script>\n{program}</script></body></html>\n"
        )

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
    return json.loads(text[begin : text.index("</script>", begin)])
