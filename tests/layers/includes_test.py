"""The check of layers finds what it is for: every line here but the last few is a breach."""

from includes import CGAL, PRINTS, TBB, breaches_of

BREACHES = [
    ('parallel', '#include "mesh/edge_table.hpp"'),
    ('parallel', '#include <surpass/mesh.hpp>'),
    ('mesh', '#include "scheme/loop.hpp"'),
    ('mesh', '#include <surpass/scheme.hpp>'),
    ('mesh', '#include <surpass/surpass.hpp>'),
    ('scheme', '#include <surpass/interpolate.hpp>'),
    ('interpolate', '#include <surpass/quality.hpp>'),
    ('io', '#include <surpass/scheme.hpp>'),
    ('io', '#include "interpolate/solvers.hpp"'),
    ('oracle', '#include "scheme/loop.hpp"'),
    ('render', '# include "mesh/edge_table.hpp"'),
    ('quality', '#include <surpass/reconstruct.hpp>'),
    ('reconstruct', '#include "io/scanner.hpp"'),
    ('apps', '#include "mesh/edge_table.hpp"'),
]
ALLOWED = [
    ('mesh', '#include "parallel/parallel.hpp"'),
    ('mesh', '#include <vector>'),
    ('scheme', '#include <surpass/topology.hpp>'),
    ('quality', '#include "scheme/loop.hpp"'),
    ('io', '#include "io/scanner.hpp"'),
    ('oracle', '#include <surpass/quality.hpp>'),
    ('render', '#include "render/camera.hpp"'),
    ('reconstruct', '#include "quality/triangle_tree.hpp"'),
    ('reconstruct', '#include <surpass/quality.hpp>'),
    ('apps', '#include <surpass/surpass.hpp>'),
    ('apps', '#include "command.hpp"'),
]

for layer, line in BREACHES:
    assert list(breaches_of(layer, line)), f'{layer}: {line} was not found'
for layer, line in ALLOWED:
    assert not list(breaches_of(layer, line)), f'{layer}: {line} was refused'
assert TBB.search('tbb::parallel_for(0, n, body);')
assert TBB.search('#include <tbb/parallel_for.h>')
assert not TBB.search('// a std::thread backend beside TBB')
assert CGAL.search('#include <CGAL/spatial_sort.h>')
assert not CGAL.search('// CGAL may be named')
for line in ('fprintf(stderr, "here");', 'std::cerr << x;', 'fmt::print("{}", x);', 'puts("x");'):
    assert PRINTS.search(line), f'{line} was not found'
for line in ('std::snprintf(to, size, "%g", x);', 'fmt::format("{}", x);', 'blueprint(x);', '[[gnu::format(printf, 1, 2)]]'):
    assert not PRINTS.search(line), f'{line} was refused'
