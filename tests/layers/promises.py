"""Every promise of the README names a test that exists: promises.py README CTEST BUILD.

The table under "Promises" has the test's name, in backquotes, in its last column; a name may end in
* for a group of tests."""

import fnmatch
import re
import subprocess
import sys


def promised(readme):
    """The test names of the table's last column, row by row."""
    section = readme.split('\n## Promises\n')[1].split('\n## ')[0]
    rows = [r for r in section.splitlines() if r.startswith('|')][2:]
    return [(r, re.findall(r'`([^`]+)`', r.rstrip(' |').rsplit('|', 1)[1])) for r in rows]


def main():
    readme, ctest, build = sys.argv[1:4]
    listing = subprocess.run([ctest, '--test-dir', build, '-N'], capture_output=True, text=True,
                             check=True).stdout
    tests = re.findall(r'^ +Test +#\d+: (\S.*)$', listing, re.MULTILINE)
    with open(readme, encoding='utf-8') as file:
        rows = promised(file.read())
    wrong = [row for row, names in rows
             if not names or not all(fnmatch.filter(tests, name) for name in names)]
    for row in wrong:
        print('names no test that exists:', row)
    print(f'{len(rows)} promises, {len(tests)} tests')
    return 1 if wrong or not rows or not tests else 0


if __name__ == '__main__':
    sys.exit(main())
