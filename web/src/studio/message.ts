// What went wrong, over the picture, with what can be done about it.
import { element } from '../viewer/dom';

export class Message {
  readonly root = element('div', { class: 'message', role: 'alert', hidden: '' });
  /** Where the focus was before it went into the message. */
  private before: HTMLElement | undefined;

  constructor(private readonly closed: () => void) {
    this.root.addEventListener('focusin', (event) => {
      const from = event.relatedTarget as HTMLElement | null;
      if (from && !this.root.contains(from)) this.before = from;
    });
    window.addEventListener('keydown', (event) => {
      if (event.key === 'Escape' && !this.root.hidden) this.close();
    });
  }

  show(words: string, note: string | undefined, actions: readonly HTMLElement[]): void {
    const close = element('button', { type: 'button', class: 'small', title: 'Escape does the same' }, 'Close');
    close.addEventListener('click', () => this.close());
    this.root.replaceChildren(element('p', {}, words),
      element('div', { class: 'actions' }, element('span', { class: 'quiet' }, note), ...actions, close));
    this.root.hidden = false;
  }

  /** The focus goes back to where it was, if it was in here. */
  hide(): void {
    const inside = this.root.contains(document.activeElement);
    this.root.hidden = true;
    if (!inside) return;
    const back = this.before?.isConnected ? this.before : document.querySelector<HTMLElement>('.stage canvas');
    back?.focus();
  }

  private close(): void {
    this.closed();
    this.hide();
  }
}

/** A button for something that helps. */
export function remedy(label: string, act: () => void): HTMLElement {
  const button = element('button', { type: 'button', class: 'small primary' }, label);
  button.addEventListener('click', act);
  return button;
}
