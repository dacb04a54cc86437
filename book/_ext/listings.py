"""Write listings with fewer elements: what no style colours needs none.

Each element costs a phone time, and commas, brackets and spaces are half of a listing's. On paper,
only a long listing may go over the page.
"""

from collections.abc import Iterable
from typing import Any

from pygments.formatters import HtmlFormatter
from pygments.token import Punctuation, Text, Whitespace
from sphinx.application import Sphinx
from sphinx.highlighting import PygmentsBridge

# Lines of code from which on it may go over the page
LONG = 12


class PlainPunctuation(HtmlFormatter):
    """Listings in which punctuation and spaces are text without an element."""

    def format_unencoded(self, tokensource: Iterable[tuple[Any, str]], outfile: Any) -> None:
        """Write the tokens."""
        plain = [
            (Text if kind in Punctuation or kind in Whitespace else kind, text)
            for kind, text in tokensource
        ]
        if "".join(text for _, text in plain).strip().count("\n") + 1 >= LONG:
            self.cssclass += " long"
        super().format_unencoded(plain, outfile)


def setup(_: Sphinx) -> dict[str, Any]:
    """Give Sphinx the formatter."""
    PygmentsBridge.html_formatter = PlainPunctuation
    return {"parallel_read_safe": True, "parallel_write_safe": True}
