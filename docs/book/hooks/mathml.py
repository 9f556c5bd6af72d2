"""Equations as MathML when the book is built: `$…$` in a line, `$$…$$` by themselves; listings stay as they are."""

import re

from latex2mathml.converter import convert

PARTS = re.compile(r"(^```.*?^```|`[^`\n]+`)|\$\$(.+?)\$\$|\$([^$\n]+)\$", re.MULTILINE | re.DOTALL)


def on_page_markdown(markdown, **_):
    def drawn(found):
        listing, alone, inline = found.groups()
        if listing:
            return listing
        if alone:
            return convert(alone.strip(), display="block")
        # A line that begins with an element which Markdown does not know would become a block.
        return f"<span>{convert(inline.strip())}</span>"

    return PARTS.sub(drawn, markdown)
