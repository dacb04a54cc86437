"""The icons that the pages show, cut out of the theme's icon font: 4 kB instead of 570.

The theme brings two thousand icons, as a script, as a font and as rules in its stylesheet. Of
the font, the glyphs named here go into a stylesheet of the book, ``icons.css``, with the font
inside it, so that they are there when the page is. The script is left out by our copy of the
theme's template (``_templates/static/webpack-macros.html``), the rules by our copy of its
stylesheet, which Sphinx puts in the place of the theme's. A test tells when a page shows an
icon that is not named here.
"""

import base64
import io
import re
from pathlib import Path
from typing import Any

import pydata_sphinx_theme
from fontTools import subset
from fontTools.ttLib import TTFont
from sphinx.application import Sphinx
from sphinx.config import Config

THEME = Path(pydata_sphinx_theme.__file__).parent / "theme" / "pydata_sphinx_theme" / "static"
THEME_STYLES = "styles/pydata-sphinx-theme.css"
FONT = THEME / "vendor" / "fontawesome" / "webfonts" / "fa-solid-900.ttf"
# The fonts of Font Awesome may be changed, but then go by another name (SIL OFL 1.1).
FAMILY = "Book Icons"

BUTTONS = [
    "angle-down",
    "angle-left",
    "angle-right",
    "arrow-up",
    "bars",
    "chevron-down",
    "circle-half-stroke",
    "download",
    "list",
    "magnifying-glass",
    "magnifying-glass-minus",
    "moon",
    "outdent",
    "sun",
    "up-right-from-square",
    "xmark",
]
BOXES = [
    "bell",
    "circle-check",
    "circle-exclamation",
    "circle-info",
    "circle-xmark",
    "lightbulb",
    "pencil",
    "share",
    "triangle-exclamation",
]

# .fa-gear:before,.fa-cog:before{content:"\\f013"}
RULE = re.compile(r'(?:\.fa-[\w-]+:before,?)+\{content:"\\([0-9a-f]+)"\}')
STYLES = """\
/* Icons of Font Awesome Free {version}, fontawesome.com, SIL OFL 1.1 */
@font-face {{
  font-family: "{family}";
  font-weight: 900;
  src: url("data:font/woff;base64,{font}") format("woff");
}}
:root {{ --fa-font-solid: normal 900 1em/1 "{family}"; }}
.fas, .fa-solid, .bd-sidebar-secondary.hide:not(:hover) .onthispage::after {{
  font-family: "{family}";
}}
"""


def cut(names: list[str]) -> TTFont:
    """Return the theme's font with the named glyphs alone."""
    font = TTFont(FONT)
    options = subset.Options(drop_tables=["FFTM", "GSUB", "GPOS"], hinting=False)
    options.name_IDs = ["*"]
    subsetter = subset.Subsetter(options)
    subsetter.populate(glyphs=names)
    subsetter.subset(font)
    for record in font["name"].names:
        if record.nameID in (1, 3, 4, 6, 16):
            record.string = FAMILY.replace(" ", "") if record.nameID == 6 else FAMILY
    font.flavor = "woff"
    return font


def write_styles(app: Sphinx, config: Config) -> None:
    """Write icons.css and the theme's other rules among the static files of the book."""
    font = cut(BUTTONS + BOXES)
    theme = (THEME / THEME_STYLES).read_text(encoding="utf-8")
    rules = [rule[0] for rule in RULE.finditer(theme) if int(rule[1], 16) in font.getBestCmap()]
    file = io.BytesIO()
    font.save(file)
    styles = STYLES.format(
        family=FAMILY,
        font=base64.b64encode(file.getvalue()).decode(),
        version=font["name"].getDebugName(5).split()[-1].rstrip(")"),
    )
    static = Path(app.outdir).parent / "static"
    (static / "styles").mkdir(parents=True, exist_ok=True)
    (static / "icons.css").write_text(styles + "\n".join(rules) + "\n", encoding="utf-8")
    (static / THEME_STYLES).write_text(RULE.sub("", theme), encoding="utf-8")
    config.html_static_path.append(str(static))
    app.add_css_file("icons.css")


def setup(app: Sphinx) -> dict[str, Any]:
    """Make the icons before Sphinx looks for static files."""
    app.connect("config-inited", write_styles)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
