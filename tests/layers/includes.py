"""Who may include whom: includes.py ROOT. Prints every include that breaks the order of layers, and who in the library
prints himself."""

import re
import sys
from pathlib import Path

# Folders of src/ and what each may include besides itself and the public headers.
MAY_INCLUDE = {
    'parallel': [],
    'mesh': ['parallel'],
    'scheme': ['parallel', 'mesh'],
    'interpolate': ['parallel', 'mesh', 'scheme'],
    'quality': ['parallel', 'mesh', 'scheme', 'interpolate'],
    'io': ['parallel', 'mesh'],
    'oracle': ['parallel'],
    'render': ['parallel'],
    'reconstruct': ['parallel', 'mesh', 'scheme', 'interpolate', 'quality'],
}
# Public headers follow the same order, so that src/mesh cannot reach schemes through them.
PUBLIC_LAYER = {
    'result': 'parallel', 'context': 'parallel', 'version': 'parallel',
    'mesh': 'mesh', 'topology': 'mesh', 'repair': 'mesh',
    'scheme': 'scheme', 'nonstationary': 'scheme', 'refiner': 'scheme', 'evaluate': 'scheme', 'interpolate': 'interpolate',
    'similarity': 'interpolate', 'requirements': 'interpolate',
    'quality': 'quality', 'fairness': 'quality', 'curvature': 'quality', 'io': 'io',
    'oracle': 'oracle', 'render': 'render', 'reconstruct': 'reconstruct',
}
OUTSIDE = ['apps', 'bindings', 'examples']  # public headers and their own files only
INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]')
TBB = re.compile(r'\btbb::|[<"](tbb|oneapi)/')
CGAL = re.compile(r'[<"]CGAL/')
CGAL_FOLDERS = ['src/reconstruct']  # under the GPL; nothing else may be
PRINTS = re.compile(r'\b(?:f?printf|f?puts|putchar|perror)\s*\(|\b(?:fmt|std)::v?print(?:ln)?\b|\bstd::(?:cout|cerr|clog)\b')


def sources(folder):
    return sorted(p for p in folder.rglob('*') if p.suffix in ('.hpp', '.cpp'))


def reason_against(layer, header, public):
    """Why a file of `layer` may not include this, or None."""
    station = PUBLIC_LAYER.get(header[:-4].removeprefix('surpass/')) if public else header.split('/')[0]
    if public and header == 'surpass/surpass.hpp':
        return None if layer in OUTSIDE else 'it includes every layer'
    if station is None or (not public and '/' not in header):
        return None if not public else 'it belongs to no layer that this test knows'
    if layer in OUTSIDE:
        return None if public or station not in MAY_INCLUDE else 'only public headers may be used here'
    if station == layer or station in MAY_INCLUDE[layer]:
        return None
    # The oracle and the pictures stand on the whole public interface.
    if public and layer in ('oracle', 'render') and station not in ('oracle', 'render'):
        return None
    return f'{layer} stands before or beside {station}'


def breaches_of(layer, text):
    """(line number, header, reason) of every include that may not be."""
    for number, line in enumerate(text.splitlines(), 1):
        found = INCLUDE.match(line)
        if not found:
            continue
        header = found.group(2)
        public = header.startswith('surpass/')
        if public or found.group(1) == '"':
            why = reason_against(layer, header, public)
            if why:
                yield number, header, why


def check(root):
    """All breaches below a folder, as sentences."""
    found = []
    jobs = [(layer, p) for layer in MAY_INCLUDE for p in sources(root / 'src' / layer)]
    jobs += [(layer, p) for layer in OUTSIDE for p in sources(root / layer)]
    jobs += [(PUBLIC_LAYER.get(p.stem, 'parallel'), p) for p in sources(root / 'include/surpass')
             if p.stem != 'surpass']
    for layer, path in jobs:
        name = path.relative_to(root)
        text = path.read_text(encoding='utf-8')
        found += [f'{name}:{n}: may not include {h}: {why}' for n, h, why in breaches_of(layer, text)]
        if layer != 'parallel' and TBB.search(text):
            found.append(f'{name}: names TBB, which only src/parallel may')
        if CGAL.search(text) and str(name.parent) not in CGAL_FOLDERS:
            found.append(f'{name}: includes CGAL, which is under the GPL: only src/reconstruct may')
        if str(name).startswith(('src/', 'include/')) and PRINTS.search(text):
            found.append(f'{name}: prints, which the library leaves to programs')
    for folder in sorted(p.name for p in (root / 'src').iterdir() if p.is_dir()):
        if folder not in MAY_INCLUDE:
            found.append(f'src/{folder}: tell tests/layers/includes.py what it may include')
    return found, len(jobs)


if __name__ == '__main__':
    breaches, files = check(Path(sys.argv[1]))
    print('\n'.join(breaches) or f'{files} files keep the order of layers')
    sys.exit(1 if breaches or not files else 0)
