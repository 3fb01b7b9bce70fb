// A little help with the document.

type Child = Node | string | undefined;

/** An element with attributes (`class`, `aria-label`, ...) and children. */
export function element<K extends keyof HTMLElementTagNameMap>(
  tag: K, attributes: Record<string, string | undefined> = {}, ...children: Child[]
): HTMLElementTagNameMap[K] {
  const made = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (value !== undefined) made.setAttribute(name, value);
  }
  made.append(...children.filter((child) => child !== undefined));
  return made;
}

export function svg(tag: string, attributes: Record<string, string | number>, ...children: (SVGElement | string)[]): SVGElement {
  const made = document.createElementNS('http://www.w3.org/2000/svg', tag);
  for (const [name, value] of Object.entries(attributes)) made.setAttribute(name, String(value));
  made.append(...children);
  return made;
}

export interface Choice<T extends string> {
  value: T;
  label: string;
  title?: string;
  disabled?: boolean;
}

let groups = 0;

/** One of a few, as buttons in a row: radio buttons for keyboard and screen reader. */
export function segmented<T extends string>(
  legend: string, choices: readonly Choice<T>[], chosen: T, change: (value: T) => void,
): HTMLFieldSetElement {
  const name = `choice-${groups++}`;
  const field = element('fieldset', { class: 'segmented' }, element('legend', {}, legend));
  for (const choice of choices) {
    const input = element('input', { type: 'radio', name, value: choice.value });
    input.checked = choice.value === chosen;
    input.disabled = choice.disabled ?? false;
    input.addEventListener('change', () => change(choice.value));
    field.append(element('label', { title: choice.title }, input, element('span', {}, choice.label)));
  }
  return field;
}

export function select<T extends string>(
  legend: string, choices: readonly Choice<T>[], chosen: T, change: (value: T) => void,
): HTMLLabelElement {
  // The name finds the control again where a form is drawn anew around the focus.
  const input = element('select', { 'aria-label': legend, id: `select-${legend.toLowerCase()}` });
  for (const choice of choices) {
    const option = element('option', { value: choice.value }, choice.label);
    option.disabled = choice.disabled ?? false;
    input.append(option);
  }
  input.value = chosen;
  input.addEventListener('change', () => change(input.value as T));
  return element('label', { class: 'field' }, element('span', { 'aria-hidden': 'true' }, legend), input);
}

export function checkbox(legend: string, checked: boolean, change: (on: boolean) => void): HTMLLabelElement {
  const input = element('input', { type: 'checkbox' });
  input.checked = checked;
  input.addEventListener('change', () => change(input.checked));
  return element('label', { class: 'check' }, input, element('span', {}, legend));
}
