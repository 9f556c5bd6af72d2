"""Fixes for what MkDocs draws differently from a git host: equations, which become MathML (`$…$` in a line, `$$…$$` by themselves), bars
in tables, words about listings and their hidden lines, and what is wider than a screen."""

import re

from latex2mathml.converter import convert

PARTS = re.compile(r"(^```.*?^```|`[^`\n]+`)|\$\$(.+?)\$\$|\$([^$\n]+)\$([,.;:)]?)", re.MULTILINE | re.DOTALL)

# rustdoc takes words about a listing, such as the error that it has to give.
LISTING = re.compile(r"^```[a-z_]+,.*$", re.MULTILINE)

# Names in a table that would be wider than its page.
NAME = re.compile(r"<code>[^<\s]{30,}</code>")

# What rustdoc compiles and does not show.
HIDDEN = re.compile(r"^# .*\n", re.MULTILINE)


def on_page_markdown(markdown, **_):
    markdown = LISTING.sub("```rust", markdown)

    def drawn(found):
        listing, alone, inline, after = found.groups()
        if listing:
            return HIDDEN.sub("", listing) if listing.startswith("```rust") else listing
        if alone:
            return convert(alone.strip(), display="block")
        # A line that begins with an element which Markdown does not know would become a block. No sign stands alone in the next line.
        return f'<span class="whole">{convert(inline.strip())}{after}</span>'

    return PARTS.sub(drawn, markdown)


def broken(name):
    """A long name that may break after a part of it."""
    return re.sub(r"(::|[/_](?!code>))", r"\1<wbr>", name.group())


def on_page_content(html, **_):
    """A bar in code in a table has a backslash before it, and a long name may break. What may be wider than a narrow screen is scrolled by
    keys, too."""
    html = re.sub("<td[ >].*?</td>", lambda cell: NAME.sub(broken, cell.group().replace(r"\|", "|")), html, flags=re.DOTALL)
    return re.sub("<(pre><span></span><code|table|math)(?=>| [^>]*display=.block)", r'<\1 tabindex="0"', html)


def on_post_template(output_content, template_name, **_):
    """The page for what is not found, which MkDocs takes to stand at the root of a host."""
    return re.sub(r'(href|src)="/', r'\1="', output_content) if template_name == "404.html" else output_content
