"""A search that also works on a disk, where a page may neither start a worker nor read a file: the index becomes a script."""

from pathlib import Path

from mkdocs.config.defaults import MkDocsConfig

HERE = Path(__file__).parent


def on_post_build(config: MkDocsConfig) -> None:
    """What MkDocs wrote for its own search gives way; its index and the library that reads it stay."""
    search = Path(config.site_dir) / "search"
    index = search / "search_index.json"
    (search / "index.js").write_text(f"const searched = {index.read_text()};\n")
    (search / "main.js").write_bytes((HERE / "search.js").read_bytes())
    for unused in (index, search / "worker.js"):
        unused.unlink()
