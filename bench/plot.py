"""Lines over two logarithmic axes, as an SVG, and where a curve's figures go."""
import json
import math

LEFT, TOP, WIDTH, HEIGHT = 70, 20, 560, 360
COLOURS = ["#000", "#1f77b4", "#ff7f0e", "#2ca02c", "#9467bd", "#8c564b"]


def log_plot(lines, x_label, x_range, x_powers, y_range, y_names, mark=None):
    """`lines` maps a name to its points (x, y), the most important one first; ranges are powers of
    ten, `y_names` maps powers to what stands beside them, `mark` is an x and what it means."""
    (x0, x1), (y0, y1) = x_range, y_range

    def x(value):
        return LEFT + (math.log10(value) - x0) / (x1 - x0) * WIDTH

    def y(value):
        return TOP + (y1 - math.log10(max(value, 10 ** y0))) / (y1 - y0) * HEIGHT

    out = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {LEFT + WIDTH + 110} '
           f'{TOP + HEIGHT + 50}" font-family="sans-serif" font-size="13">',
           '<rect width="100%" height="100%" fill="white"/>']
    for power in x_powers:
        at = x(10 ** power)
        out.append(f'<path d="M{at:.1f} {TOP}V{TOP + HEIGHT}" stroke="#ddd"/>'
                   f'<text x="{at:.1f}" y="{TOP + HEIGHT + 18}" text-anchor="middle">'
                   f'{10 ** power:,}</text>')
    for power, name in y_names.items():
        at = y(10 ** power)
        out.append(f'<path d="M{LEFT} {at:.1f}H{LEFT + WIDTH}" stroke="#ddd"/>'
                   f'<text x="{LEFT - 8}" y="{at + 4:.1f}" text-anchor="end">{name}</text>')
    if mark:
        at = x(mark[0])
        out.append(f'<path d="M{at:.1f} {TOP}V{TOP + HEIGHT}" stroke="#c00" stroke-dasharray="6 4"/>'
                   f'<text x="{at + 6:.1f}" y="{TOP + 16}" fill="#c00">{mark[1]}</text>')
    out.append(f'<text x="{LEFT + WIDTH / 2}" y="{TOP + HEIGHT + 40}" text-anchor="middle">{x_label}'
               '</text>')
    ends = []
    for i, (name, points) in enumerate(lines.items()):
        places = [(x(px), y(py)) for px, py in points]
        line = " ".join(f"{px:.1f},{py:.1f}" for px, py in places)
        out.append(f'<polyline points="{line}" fill="none" stroke="{COLOURS[i]}" '
                   f'stroke-width="{2.5 if i == 0 else 1.5}"/>')
        ends.append((places[-1], name, COLOURS[i]))
    last = -100.0
    for (px, py), name, colour in sorted(ends, key=lambda end: end[0][1]):
        last = max(py, last + 14)  # names that would lie on each other move down
        out.append(f'<text x="{px + 6:.1f}" y="{last + 4:.1f}" fill="{colour}">{name}</text>')
    return "\n".join([*out, "</svg>", ""])


def publish(figures, text, results, name, drawing, picture):
    """Leaves the raw figures and their table in the folder `results`, the drawing in `picture`."""
    (results / f"{name}.json").write_text(json.dumps(figures, indent=1) + "\n")
    (results / f"{name}.md").write_text(text + "\n")
    picture.write_text(drawing)
    print(text)
