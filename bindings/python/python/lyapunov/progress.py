"""Progress of long work: a bar in notebooks and terminals."""

from __future__ import annotations

import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from importlib import import_module
from typing import Any

AFTER = 1.0
"""Time before a bar appears, s: short work shows none."""


@contextmanager
def shown(progress: bool | Callable[[int, int], object] | None, name: str) -> Iterator[Callable[[int, int], object] | None]:
    """What is called with (done, total) now and then."""
    if callable(progress):
        yield progress
        return
    in_notebook = _is_in_notebook()
    if progress is False or (progress is None and not in_notebook and not sys.stderr.isatty()):
        yield None
        return
    bar = _InNotebook(name) if in_notebook else _InTerminal(name)
    try:
        yield bar
    finally:
        bar.close()


def _is_in_notebook() -> bool:
    module = sys.modules.get("IPython")
    shell = module.get_ipython() if module is not None else None
    return shell is not None and hasattr(shell, "kernel")


class _Bar:
    def __init__(self, name: str) -> None:
        self.name = name
        self.began = time.monotonic()
        self.is_shown = False

    def __call__(self, done: int, total: int) -> None:
        passed = time.monotonic() - self.began
        if total == 0 or (passed < AFTER and not self.is_shown):
            return
        share = min(done / total, 1.0)
        left = f", {passed / share - passed:.0f} s left" if 0.0 < share < 1.0 else ""
        self.show(share, f"{self.name}: {100 * share:.0f} %{left}")
        self.is_shown = True

    def show(self, share: float, text: str) -> None:
        raise NotImplementedError

    def close(self) -> None:
        """Takes the bar away."""


class _InTerminal(_Bar):
    def show(self, share: float, text: str) -> None:
        filled = round(40 * share)
        sys.stderr.write(f"\r[{'#' * filled}{'.' * (40 - filled)}] {text}\x1b[K")
        sys.stderr.flush()

    def close(self) -> None:
        if self.is_shown:
            sys.stderr.write("\r\x1b[K")
            sys.stderr.flush()


class _InNotebook(_Bar):
    handle: Any = None

    def show(self, share: float, text: str) -> None:
        display: Any = import_module("IPython.display")
        bar = display.HTML(f"<progress max='1' value='{share:.3f}'></progress> {text}")
        if self.handle is None:
            self.handle = display.display(bar, display_id=True)
        else:
            self.handle.update(bar)

    def close(self) -> None:
        if self.handle is not None:
            display: Any = import_module("IPython.display")
            self.handle.update(display.HTML(""))
