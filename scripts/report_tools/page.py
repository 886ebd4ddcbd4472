"""A page of text, tables and pictures, written as Markdown and as HTML."""
import html
import re
from typing import NamedTuple, Optional, Tuple
from urllib.parse import quote

from report_tools.tables import Table


class Heading(NamedTuple):
    level: int  # 1 to 3
    text: str


class Paragraph(NamedTuple):
    text: str


class Bullets(NamedTuple):
    items: Tuple[str, ...]


class Code(NamedTuple):
    text: str


class FigureLink(NamedTuple):
    """A figure of which there are base.png and base.svg."""
    base: str
    caption: str


class Pictures(NamedTuple):
    """Columns of a caption and the paths of the pictures below it, None where one is missing."""
    columns: Tuple[Tuple[str, Tuple[Optional[str], ...]], ...]


_PICTURES_PER_ROW = 4  # in Markdown; HTML fills the width of the window

_STYLE = """
body { font-family: sans-serif; max-width: 75em; margin: 2em auto; padding: 0 1em;
       color: #222; line-height: 1.4; }
h2 { border-bottom: 1px solid #ccc; margin-top: 2em; }
.scroll { overflow-x: auto; }
table { border-collapse: collapse; margin: 1em 0; }
th, td { padding: 0.2em 0.7em; text-align: right; border-bottom: 1px solid #e4e4e4; }
th:first-child, td:first-child { text-align: left; }
thead th { border-bottom: 1px solid #888; vertical-align: bottom; }
tfoot td { font-weight: bold; }
.pictures { display: flex; flex-wrap: wrap; gap: 0.6em; }
.pictures figure { flex: 0 0 calc(25% - 0.5em); min-width: 10em; margin: 0; text-align: center; }
figcaption { overflow-wrap: anywhere; font-size: 0.9em; }
img { max-width: 100%; }
pre { background: #f4f4f4; padding: 0.7em; overflow-x: auto; }
"""


def _html_row(cells, tag):
    return "<tr>%s</tr>" % "".join("<%s>%s</%s>" % (tag, html.escape(cell), tag) for cell in cells)


def _html_table(table):
    parts = ["<div class=\"scroll\"><table>", "<thead>" + _html_row(table.head, "th") + "</thead>",
             "<tbody>"]
    parts += [_html_row(row, "td") for row in table.rows]
    parts.append("</tbody>")
    if table.foot:
        parts += ["<tfoot>", *(_html_row(row, "td") for row in table.foot), "</tfoot>"]
    return "\n".join(parts + ["</table></div>"])


def _html_picture(path, caption):
    if path is None:
        return "<p>-</p>"
    link = quote(path)
    return "<a href=\"%s\"><img loading=\"lazy\" src=\"%s\" alt=\"%s\"></a>" % (
        link, link, html.escape(caption))


def _html_pictures(pictures):
    columns = ("<figure><figcaption>%s</figcaption>%s</figure>" % (
        html.escape(caption), "".join(_html_picture(path, caption) for path in paths))
               for caption, paths in pictures.columns)
    return "<div class=\"pictures\">\n%s\n</div>" % "\n".join(columns)


def _html_figure(figure):
    link = quote(figure.base)
    return ("<p><img src=\"%s.svg\" alt=\"%s\"><br><a href=\"%s.png\">PNG</a> "
            "<a href=\"%s.svg\">SVG</a></p>" % (link, html.escape(figure.caption), link, link))


_HTML = {
    Heading: lambda block: "<h%d>%s</h%d>" % (block.level, html.escape(block.text), block.level),
    Paragraph: lambda block: "<p>%s</p>" % html.escape(block.text),
    Bullets: lambda block: "<ul>\n%s\n</ul>" % "\n".join(
        "<li>%s</li>" % html.escape(item) for item in block.items),
    Code: lambda block: "<pre>%s</pre>" % html.escape(block.text),
    Table: _html_table,
    FigureLink: _html_figure,
    Pictures: _html_pictures,
}


def to_html(blocks):
    """The page as HTML; its title is the first heading."""
    title = next(block.text for block in blocks if isinstance(block, Heading))
    body = "\n".join(_HTML[type(block)](block) for block in blocks)
    return ("<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
            "<title>%s</title>\n<style>%s</style>\n</head>\n<body>\n%s\n</body>\n</html>\n" %
            (html.escape(title), _STYLE, body))


def _markdown_text(text):
    return re.sub(r"([\\`*_|<>\[\]])", r"\\\1", text)


def _markdown_row(cells):
    return "| %s |" % " | ".join(cells)


def _markdown_table(table):
    rows = [_markdown_row(map(_markdown_text, table.head)),
            "|---|" + "---:|" * (len(table.head) - 1)]
    rows += [_markdown_row(map(_markdown_text, row)) for row in table.rows]
    rows += [_markdown_row("**%s**" % _markdown_text(cell) if cell else "" for cell in row)
             for row in table.foot]
    return "\n".join(rows)


def _markdown_image(caption, path):
    return "![%s](%s)" % (_markdown_text(caption), quote(path))


def _markdown_pictures(pictures):
    return "\n\n".join(_markdown_picture_rows(pictures.columns[start:start + _PICTURES_PER_ROW])
                       for start in range(0, len(pictures.columns), _PICTURES_PER_ROW))


def _markdown_picture_rows(columns):
    rows = [_markdown_row(_markdown_text(caption) for caption, _ in columns),
            "|" + ":---:|" * len(columns)]
    images = [["-" if path is None else _markdown_image(caption, path) for path in paths]
              for caption, paths in columns]
    return "\n".join(rows + [_markdown_row(row) for row in zip(*images)])


_MARKDOWN = {
    Heading: lambda block: "#" * block.level + " " + _markdown_text(block.text),
    Paragraph: lambda block: _markdown_text(block.text),
    Bullets: lambda block: "\n".join("- " + _markdown_text(item) for item in block.items),
    Code: lambda block: "\n".join("    " + line for line in block.text.splitlines()),
    Table: _markdown_table,
    FigureLink: lambda block: _markdown_image(block.caption, block.base + ".png"),
    Pictures: _markdown_pictures,
}


def to_markdown(blocks):
    """The page as Markdown of GitHub's dialect."""
    return "\n\n".join(_MARKDOWN[type(block)](block) for block in blocks) + "\n"
