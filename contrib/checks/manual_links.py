# SPDX-License-Identifier: LGPL-2.1-or-later
"""
Links and pictures of the HTML manual. Doxygen 1.9 leaves some links between Markdown pages as they are written: links to a
heading of another page, pictures in a folder above, files that are not pages. Here they get their targets.
"""
import re
import shutil
from pathlib import Path
from urllib.parse import unquote

REFERENCE = re.compile(r'\b(href|src|data)="([^"]+)"')
ANCHOR = re.compile(r'<h\d[^>]*>\s*<a class="anchor" id="([^"]+)"></a>\s*(.*?)</h\d>', re.S)


def page_name(root, source):
    """The HTML page that doxygen makes of a Markdown file."""
    if source == root / "README.md":
        return "index.html"
    return "md_" + re.sub(r"\W", "_", str(source.relative_to(root).with_suffix(""))) + ".html"


def slug(heading):
    """The name that GitHub gives to a heading, from its HTML."""
    text = re.sub(r"<[^>]*>", "", heading).strip().lower()
    return re.sub(r"[^\w\- ]", "", text).replace(" ", "-")


def target(root, html, source, reference):
    """What a reference of a page should be, or None if it is right or leads nowhere."""
    if re.match(r"[a-z]+:", reference):
        return None
    name, _, anchor = unquote(reference).partition("#")
    if not name or (html / name).exists():
        return None
    wanted = (source.parent / name).resolve()
    if not wanted.is_relative_to(root) or not wanted.is_file():
        return None
    if wanted.suffix != ".md":
        shutil.copy(wanted, html / wanted.name)
        return wanted.name
    page = html / page_name(root, wanted)
    if not page.exists():
        return None
    ids = {slug(title): name for name, title in ANCHOR.findall(page.read_text(encoding="utf-8"))}
    return page.name + (f"#{ids[anchor]}" if anchor in ids else "")


def mend(root, html):
    """Gives every reference of the pages that are made of Markdown its target."""
    for source in [*root.glob("*.md"), *(root / "doc").rglob("*.md")]:
        page = html / page_name(root, source)
        if page.exists():
            text = page.read_text(encoding="utf-8")
            page.write_text(REFERENCE.sub(
                lambda found, here=source: f'{found[1]}="{target(root, html, here, found[2]) or found[2]}"', text),
                encoding="utf-8")


def broken(html):
    """References of the manual's pages that lead nowhere."""
    for page in sorted([*html.glob("md_*.html"), html / "index.html"]):
        for _, reference in REFERENCE.findall(page.read_text(encoding="utf-8")):
            name = unquote(reference).partition("#")[0]
            if name and not re.match(r"[a-z]+:", reference) and not (html / name).exists():
                yield f"{page.name}: link to nothing: {reference}"


def self_test(place):
    """A page with links of each kind is mended, and one that leads nowhere is found."""
    root, html = Path(place) / "root", Path(place) / "html"
    (root / "doc/results").mkdir(parents=True)
    html.mkdir()
    for name in ("README.md", "doc/a.md", "doc/results/b.md", "doc/c.bib"):
        (root / name).write_text("", encoding="utf-8")
    (html / "index.html").write_text('<a href="gone.md"> <a href="https://example.org/x.md">', encoding="utf-8")
    (html / "md_doc_a.html").write_text('<h2><a class="anchor" id="autotoc_md7"></a>\nIt `is`, so</h2>', encoding="utf-8")
    (html / "md_doc_results_b.html").write_text('<a href="../a.md#it-is-so"> <img src="../c.bib">', encoding="utf-8")
    mend(root, html)
    return ((html / "md_doc_results_b.html").read_text(encoding="utf-8") ==
            '<a href="md_doc_a.html#autotoc_md7"> <img src="c.bib">'
            and list(broken(html)) == ["index.html: link to nothing: gone.md"])
