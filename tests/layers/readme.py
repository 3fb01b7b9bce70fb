"""The README keeps its word: readme.py ROOT CTEST BUILD [ABSENT].

The table under "Promises" names, in backquotes in its last column, tests that exist; a name may
hold * for a group of tests. Names that match ABSENT are of tests that this build leaves out. The
C++ program is examples/interpolate.cpp to the letter."""

import fnmatch
import re
import subprocess
import sys
from pathlib import Path


def promises(readme):
    """The table's promises, each with the test names of its last column."""
    section = readme.split('\n## Promises\n')[1].split('\n## ')[0]
    rows = [r for r in section.splitlines() if r.startswith('|')][2:]
    cells = [r.strip('| ').rsplit('|', 1) for r in rows]
    return [(promise.strip(), re.findall(r'`([^`]+)`', tests)) for promise, tests in cells]


def names_of_tests(ctest, build):
    listing = subprocess.run([ctest, '--test-dir', build, '-N'], capture_output=True, text=True,
                             check=True).stdout
    return re.findall(r'^ +Test +#\d+: (\S.*)$', listing, re.MULTILINE)


def main():
    root, ctest, build = Path(sys.argv[1]), sys.argv[2], sys.argv[3]
    absent = sys.argv[4] if len(sys.argv) > 4 else ''
    readme = (root / 'README.md').read_text(encoding='utf-8')
    tests = names_of_tests(ctest, build)
    rows = promises(readme)
    wrong = [f'no test is called {name}: {promise}' for promise, names in rows
             for name in names or ['(nothing)']
             if not fnmatch.filter(tests, name) and not fnmatch.fnmatch(name, absent)]
    program = re.search(r'```cpp\n(.*?)```', readme, re.DOTALL).group(1)
    if program != (root / 'examples/interpolate.cpp').read_text(encoding='utf-8'):
        wrong.append('the program in README.md is not examples/interpolate.cpp')
    print('\n'.join(wrong) or f'{len(rows)} promises, {len(tests)} tests')
    return 1 if wrong or not rows else 0


if __name__ == '__main__':
    sys.exit(main())
