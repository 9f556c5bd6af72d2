"""The notebooks run from the first cell to the last; what they claim is asserted in their cells."""

import pathlib

import pytest

reason = "SKIPPED: the notebooks: there is no nbclient or no ipykernel"
nbclient = pytest.importorskip("nbclient", reason=reason)
pytest.importorskip("ipykernel", reason=reason)
nbformat = pytest.importorskip("nbformat", reason=reason)

FOLDER = pathlib.Path(__file__).parents[2] / "notebooks"
NAMES = sorted(path.stem for path in FOLDER.glob("*.ipynb"))


def test_there_are_notebooks():
    assert set(NAMES) == {"how-stiff-may-my-wall-be", "write-a-candidate", "your-first-stabilizer", "your-own-log"}


@pytest.mark.parametrize("name", NAMES)
def test_a_notebook_runs(name, tmp_path):
    notebook = nbformat.read(FOLDER / f"{name}.ipynb", as_version=4)
    assert any("assert" in cell.source for cell in notebook.cells if cell.cell_type == "code")
    resources = {"metadata": {"path": tmp_path}}
    nbclient.NotebookClient(notebook, timeout=300, kernel_name="python3", resources=resources).execute()
