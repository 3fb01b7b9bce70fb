"""The folder of real meshes that scripts measure on, which nobody must have."""
import pathlib
import sys


def folder_or_skip(given, cases, what):
    """The folder's absolute path; where none is given, says how many cases that skips and ends well."""
    if not given:
        print(f"{what}: {cases} cases were skipped; they need a folder of real meshes, DATA=DIR.")
        sys.exit(0)
    folder = pathlib.Path(given).resolve()
    if not folder.is_dir():
        sys.exit(f"{what}: there is no folder {given}")
    return folder
