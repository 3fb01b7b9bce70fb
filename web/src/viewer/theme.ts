// Light or dark: as the system is, until the visitor chooses.
import { element } from './dom';

export function themeButton(change: (dark: boolean) => void): HTMLButtonElement {
  const system = window.matchMedia('(prefers-color-scheme: dark)');
  let dark = system.matches;
  let chosen = false;
  const button = element('button', { type: 'button', class: 'small theme' });
  const apply = () => {
    document.documentElement.dataset.theme = dark ? 'dark' : 'light';
    button.textContent = dark ? 'Light' : 'Dark';
    button.title = dark ? 'Light colours' : 'Dark colours';
    change(dark);
  };
  button.addEventListener('click', () => {
    chosen = true;
    dark = !dark;
    apply();
  });
  system.addEventListener('change', (event) => {
    if (chosen) return;
    dark = event.matches;
    apply();
  });
  apply();
  return button;
}
