"""Markdown and HTML of the blocks of a page."""
import unittest
from html.parser import HTMLParser

from report_tools.page import (
    Bullets, Code, FigureLink, Heading, Paragraph, Pictures, to_html, to_markdown)
from report_tools.tables import Table

_VOID = ("meta", "img", "br")


class _Balance(HTMLParser):
    """Keeps the elements that are open; fails where one is closed that is not."""

    def __init__(self):
        super().__init__()
        self.open = []
        self.sources = []

    def handle_starttag(self, tag, attrs):
        if tag not in _VOID:
            self.open.append(tag)
        self.sources += [value for name, value in attrs if name in ("src", "href")]

    def handle_endtag(self, tag):
        if self.open.pop() != tag:
            raise ValueError("</%s> closes nothing" % tag)


class MarkdownTest(unittest.TestCase):
    def test_table(self):
        text = to_markdown([Table(("scene", "SGM"), (("a|b", "1.0"),), (("mean", ""),))])
        self.assertEqual(text, "| scene | SGM |\n|---|---:|\n| a\\|b | 1.0 |\n| **mean** |  |\n")

    def test_text_is_not_taken_for_markup(self):
        self.assertEqual(to_markdown([Heading(2, "my_own_*scene*"), Bullets(("<b>", "[x]"))]),
                         "## my\\_own\\_\\*scene\\*\n\n- \\<b\\>\n- \\[x\\]\n")
        self.assertEqual(to_markdown([Code("a_b *\nc")]), "    a_b *\n    c\n")

    def test_pictures_come_in_rows_of_four(self):
        columns = tuple(("v%d" % i, ("d %d.png" % i, None)) for i in range(5))
        text = to_markdown([Pictures(columns)])
        self.assertEqual(text.splitlines()[0], "| v0 | v1 | v2 | v3 |")
        self.assertEqual(text.splitlines()[5:], ["| v4 |", "|:---:|", "| ![v4](d%204.png) |",
                                                 "| - |"])

    def test_figure(self):
        self.assertEqual(to_markdown([FigureLink("figures/gains", "Gains")]),
                         "![Gains](figures/gains.png)\n")


class HtmlTest(unittest.TestCase):
    def test_elements_are_closed_and_links_relative(self):
        page = to_html([Heading(1, "T"), Paragraph("p"), Bullets(("a", "b")), Code("c"),
                        Table(("x", "y"), (("1", "2"),), (("3", "4"),)),
                        FigureLink("figures/f", "F"), Pictures((("v", ("maps/a b.png", None)),))])
        parser = _Balance()
        parser.feed(page)
        self.assertEqual(parser.open, [])
        self.assertEqual(parser.sources, ["figures/f.svg", "figures/f.png", "figures/f.svg",
                                          "maps/a%20b.png", "maps/a%20b.png"])

    def test_text_is_escaped(self):
        page = to_html([Heading(1, "<script>"), Table(("a&b",), (("<i>",),))])
        self.assertIn("<title>&lt;script&gt;</title>", page)
        self.assertIn("<th>a&amp;b</th>", page)
        self.assertIn("<td>&lt;i&gt;</td>", page)

    def test_missing_picture(self):
        self.assertIn("<figcaption>v</figcaption><p>-</p></figure>",
                      to_html([Heading(1, "T"), Pictures((("v", (None,)),))]))


if __name__ == "__main__":
    unittest.main()
