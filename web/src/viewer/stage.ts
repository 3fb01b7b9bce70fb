// The viewer with what is laid over it - labels, legend, divider - and the toolbar that steers it.
// Studio and report both are built around one.
import { cssGradient, kFlat, shortNumber } from './colour';
import { checkbox, element, segmented, select } from './dom';
import { isSigned, kShadings, type Shading } from './materials';
import { Viewer, type Content } from './viewer';
import { defaultView, panesOf, type Mode, type View } from './views';

const kShadingNames: Record<Shading, string> = {
  matte: 'Matte', reflection: 'Reflection', mean: 'Mean', gauss: 'Gauss', error: 'Error', distance: 'Distance',
};
const kShadingTitles: Record<Shading, string> = {
  matte: 'Clay under a soft light',
  reflection: 'Reflection lines: where they break, the surface has a kink; where they wiggle, a ripple',
  mean: 'Mean curvature',
  gauss: 'Gaussian curvature: positive on bumps, negative on saddles',
  error: 'How far the plain limit surface is from the given points',
  distance: 'How far the other mesh is: at the corners of the shown triangles exactly, between them smoothed',
};
const kLegends: Partial<Record<Shading, string>> = {
  mean: 'Mean curvature, 1 / box side',
  gauss: 'Gaussian curvature, 1 / box side²',
  error: 'Distance to the given points, of the box side',
  distance: 'Distance to the other mesh, files’ unit',
};
const kModes: readonly { value: Mode; label: string; title: string }[] = [
  { value: 'single', label: 'One', title: 'One thing alone' },
  { value: 'overlay', label: 'Overlay', title: 'Several things in one place' },
  { value: 'split', label: 'Split', title: 'Two things side by side, seen from the same place' },
];

/** Pixels that the names of what is shown take. */
const kLabelHeight = 24;

export class Stage {
  readonly root: HTMLElement;
  readonly viewer: Viewer;
  /** What is shown; and what is wished for, though the mesh of now may not have it. */
  view = defaultView();
  private wish = defaultView();
  private content: Content = { layers: [] };
  private readonly toolbar = element('div', { class: 'toolbar', role: 'toolbar', 'aria-label': 'View' });
  private readonly canvasBox = element('div', { class: 'canvas-box' });
  private readonly labels = element('div', { class: 'labels' });
  private readonly legend = element('div', { class: 'legend', hidden: '' });
  private readonly divider = element('div', {
    class: 'divider', role: 'separator', tabindex: '0', 'aria-orientation': 'vertical',
    'aria-label': 'Divider of the split', 'aria-valuemin': '5', 'aria-valuemax': '95', hidden: '',
  });
  private shownToolbar = '';

  constructor() {
    this.root = element('section', { class: 'stage', 'aria-label': 'Picture' }, this.toolbar,
      element('div', { class: 'canvas-frame' }, this.canvasBox, this.labels, this.divider, this.legend));
    this.viewer = new Viewer(this.canvasBox, this.view);
    this.viewer.canvas.setAttribute('role', 'img');
    this.steerDivider();
    this.toolbar.addEventListener('scroll', () => this.fadeToolbar());
    new ResizeObserver(() => this.revealChosen()).observe(this.toolbar);
    window.addEventListener('keydown', (event) => this.key(event));
  }

  /** For overlays of the page's own: progress, messages. */
  get frame(): HTMLElement {
    return this.root.querySelector('.canvas-frame')!;
  }

  show(content: Content): void {
    this.content = content;
    this.settle();
    this.viewer.show(content);
    this.update();
  }

  change(part: Partial<View>): void {
    this.wish = { ...this.wish, ...part };
    this.settle();
    this.update();
  }

  setDark(dark: boolean): void {
    this.viewer.setDark(dark);
  }

  // Whatever is asked for must be among what there is.
  private settle(): void {
    const ids = this.content.layers.map((l) => l.id);
    const or = (id: string, other: string | undefined) => (ids.includes(id) ? id : (other ?? ''));
    const view = { ...this.wish };
    const last = ids.at(-1);
    view.single = or(view.single, last);
    view.right = or(view.right, last);
    view.left = or(view.left, ids.length > 1 ? ids[0] : last);
    const overlay = view.overlay.filter((id) => ids.includes(id));
    // All, where none of the wished ones is there; nothing, if nothing is wished.
    view.overlay = overlay.length > 0 || view.overlay.length === 0 ? overlay : ids;
    const has = this.shadings();
    if (!has.includes(view.shading)) view.shading = 'matte';
    if (ids.length < 2) view.mode = 'single';
    this.view = view;
  }

  private shadings(): readonly Shading[] {
    const surfaces = this.content.layers.filter((l) => l.kind === 'surface');
    if (surfaces.length === 0) return ['matte'];
    return kShadings.filter((s) => s === 'matte' || s === 'reflection' ||
      surfaces.some((l) => l.shape.channels[s] !== undefined));
  }

  private update(): void {
    this.drawToolbar();
    this.drawOverlays();
    this.viewer.insets = { top: kLabelHeight, bottom: this.legend.hidden ? 0 : this.legend.offsetHeight + 18 };
    this.viewer.setView(this.view);
  }

  // Drawn anew only if its shape changes: a control that is being used must keep the focus.
  private drawToolbar(): void {
    const { layers } = this.content;
    const key = JSON.stringify([layers.map((l) => [l.id, l.label]), this.shadings(), this.view.mode,
      this.content.points !== undefined, this.view.shading, this.view.single, this.view.overlay,
      this.view.left, this.view.right, this.view.points, this.view.marks, this.view.up]);
    if (key === this.shownToolbar) return;
    this.shownToolbar = key;
    const focused = document.activeElement;
    const where = focused && this.toolbar.contains(focused) ? pathOf(this.toolbar, focused) : undefined;
    const choices = layers.map((l) => ({ value: l.id, label: l.label }));
    const parts: HTMLElement[] = [];
    if (layers.length > 1) {
      parts.push(segmented('Layout', kModes, this.view.mode, (mode) => this.change({ mode })));
      parts.push(...this.pickers(choices));
    }
    const shadings = this.shadings();
    if (shadings.length > 1) {
      parts.push(segmented('Shading', shadings.map((s) => ({ value: s, label: kShadingNames[s], title: kShadingTitles[s] })),
        this.view.shading, (shading) => this.change({ shading })));
    }
    const extras = element('div', { class: 'extras' });
    if (this.content.points) {
      extras.append(checkbox('Points', this.view.points, (points) => this.change({ points })));
    }
    if (layers.some((l) => l.kind !== 'points')) {
      extras.append(checkbox('Creases and boundary', this.view.marks, (marks) => this.change({ marks })));
    }
    const upright = element('button', { type: 'button', class: 'small', title: 'Which axis points up' },
      `${this.view.up.toUpperCase()} up`);
    upright.addEventListener('click', () => this.change({ up: this.view.up === 'y' ? 'z' : 'y' }));
    const home = element('button', { type: 'button', class: 'small', title: 'The first view again (Home)' }, 'Reset view');
    home.addEventListener('click', () => this.viewer.home());
    extras.append(upright, home);
    this.toolbar.replaceChildren(...parts, extras);
    if (where) (elementAt(this.toolbar, where) as HTMLElement | undefined)?.focus();
    this.revealChosen();
  }

  // Where the toolbar is one row that scrolls: what is being used, or else what is shown, is in view.
  private revealChosen(): void {
    const used = this.toolbar.contains(document.activeElement) ? document.activeElement : this.toolbar.querySelector('.shown :checked');
    const box = used?.closest('label, button')?.getBoundingClientRect();
    const bar = this.toolbar.getBoundingClientRect();
    const room = 40;  // for the fading edges
    if (box && box.right > bar.right - room) this.toolbar.scrollLeft += box.right - bar.right + room;
    else if (box && box.left < bar.left + room) this.toolbar.scrollLeft += box.left - bar.left - room;
    this.fadeToolbar();
  }

  // Edges fade out where there is more.
  private fadeToolbar(): void {
    const { scrollLeft, scrollWidth, clientWidth, classList } = this.toolbar;
    classList.toggle('more-left', scrollLeft > 2);
    classList.toggle('more-right', scrollLeft + clientWidth < scrollWidth - 2);
  }

  private pickers(choices: { value: string; label: string }[]): HTMLElement[] {
    const view = this.view;
    if (view.mode === 'single') {
      const field = segmented('Shown', choices, view.single, (single) => this.change({ single }));
      field.classList.add('shown');
      return [field];
    }
    if (view.mode === 'split') {
      return [select('Left', choices, view.left, (left) => this.change({ left })),
        select('Right', choices, view.right, (right) => this.change({ right }))];
    }
    const field = element('fieldset', { class: 'checks' }, element('legend', {}, 'Shown'));
    for (const { value, label } of choices) {
      field.append(checkbox(label, view.overlay.includes(value), (on) => {
        // What the mesh of now does not have stays wished for another one.
        const absent = this.wish.overlay.filter((id) => !choices.some((c) => c.value === id));
        const rest = view.overlay.filter((id) => id !== value);
        this.change({ overlay: [...absent, ...rest, ...(on ? [value] : [])] });
      }));
    }
    return [field];
  }

  private drawOverlays(): void {
    const { view } = this;
    const name = (id: string) => this.content.layers.find((l) => l.id === id)?.label ?? '';
    const panes = panesOf(view);
    this.labels.replaceChildren(...panes.map((pane) => {
      const label = element('div', { class: 'pane-label' }, pane.ids.map(name).join(' + '));
      label.style.left = `${pane.from * 100}%`;
      label.style.width = `${(pane.to - pane.from) * 100}%`;
      return label;
    }));
    this.viewer.canvas.setAttribute('aria-label', `3D picture: ${panes.flatMap((p) => p.ids.map(name)).join(', ')}. `
      + 'Arrow keys turn it, plus and minus zoom, Home resets.');
    this.divider.hidden = view.mode !== 'split';
    this.divider.style.left = `${view.split * 100}%`;
    this.divider.setAttribute('aria-valuenow', String(Math.round(view.split * 100)));
    this.drawLegend();
  }

  private drawLegend(): void {
    const title = kLegends[this.view.shading];
    this.legend.hidden = title === undefined;
    if (title === undefined || this.view.shading === 'matte' || this.view.shading === 'reflection') return;
    const scale = this.viewer.scales[this.view.shading];
    const signed = isSigned(this.view.shading);
    const bar = element('div', { class: 'legend-bar' });
    bar.style.background = cssGradient(signed ? 'diverging' : 'sequential');
    const ticks = signed && scale <= kFlat ? ['0'] : signed ? [shortNumber(-scale), '0', shortNumber(scale)] : ['0', shortNumber(scale)];
    this.legend.replaceChildren(element('div', { class: 'legend-title' }, title), bar,
      element('div', { class: ticks.length > 1 ? 'legend-ticks' : 'legend-ticks one' }, ...ticks.map((t) => element('span', {}, t))));
  }

  private steerDivider(): void {
    const move = (to: number) => this.change({ split: Math.min(0.95, Math.max(0.05, to)) });
    this.divider.addEventListener('pointerdown', (event) => {
      this.divider.setPointerCapture(event.pointerId);
      event.preventDefault();
      this.divider.focus();
    });
    this.divider.addEventListener('pointermove', (event) => {
      if (!this.divider.hasPointerCapture(event.pointerId)) return;
      const box = this.canvasBox.getBoundingClientRect();
      move((event.clientX - box.left) / box.width);
    });
    this.divider.addEventListener('dblclick', () => move(0.5));
    this.divider.addEventListener('keydown', (event) => {
      const step = { ArrowLeft: -0.02, ArrowRight: 0.02, Home: -1, End: 1 }[event.key];
      if (step === undefined) return;
      event.preventDefault();
      move(this.view.split + step);
    });
  }

  private key(event: KeyboardEvent): void {
    const target = event.target as HTMLElement;
    if (event.ctrlKey || event.metaKey || event.altKey || target.matches('input:not([type=checkbox]):not([type=radio]), select, textarea')) return;
    const shading = kShadings[Number(event.key) - 1];
    if (shading && this.shadings().includes(shading)) this.change({ shading });
    if (event.key === 's' && this.content.layers.length > 1) {
      this.change({ mode: this.view.mode === 'split' ? 'single' : 'split' });
    }
    if (event.key === 'p') this.change({ points: !this.view.points });
  }
}

function pathOf(root: Element, inside: Element): number[] {
  const path: number[] = [];
  for (let e = inside; e !== root; e = e.parentElement!) path.unshift([...e.parentElement!.children].indexOf(e));
  return path;
}
function elementAt(root: Element, path: readonly number[]): Element | undefined {
  return path.reduce<Element | undefined>((e, i) => e?.children[i], root);
}
