// A browser without a network, and what tests ask of a page.
import { existsSync } from 'node:fs';
import { chromium, type Browser, type BrowserContext, type Locator, type Page } from 'playwright-core';
import { expect } from 'vitest';

const kBrowsers = [process.env.CHROMIUM, '/usr/bin/chromium', '/usr/bin/chromium-browser', '/usr/bin/google-chrome'];

export async function launch(): Promise<Browser> {
  const executablePath = kBrowsers.find((path) => path !== undefined && existsSync(path));
  if (!executablePath) throw new Error('no Chromium was found: install it, or name it in CHROMIUM');
  // Pictures by software: the same on every machine.
  const args = ['--no-sandbox', '--use-gl=angle', '--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--ignore-gpu-blocklist'];
  return chromium.launch({ executablePath, args });
}

export interface Opened {
  page: Page;
  context: BrowserContext;
  /** Errors on the console, exceptions, and requests that went anywhere but into files. */
  complaints: string[];
}

export async function open(browser: Browser, url: string, options: Parameters<Browser['newContext']>[0] = {}): Promise<Opened> {
  const context = await browser.newContext({ viewport: { width: 1190, height: 620 }, deviceScaleFactor: 0.5, acceptDownloads: true, ...options });
  const complaints: string[] = [];
  await context.setOffline(true);
  const page = await context.newPage();
  // Long enough for a machine that does other things as well.
  page.setDefaultTimeout(60000);
  page.on('console', (message) => {
    if (message.type() === 'error' || message.type() === 'warning') {
      // Reading pixels back, as the tests do, is slow, and the browser says so.
      if (!/GPU stall due to ReadPixels/.test(message.text())) complaints.push(message.text());
    }
  });
  page.on('pageerror', (error) => complaints.push(error.message));
  page.on('request', (request) => {
    if (!/^(file|blob|data):/.test(request.url())) complaints.push(`asked for ${request.url()}`);
  });
  await page.goto(url);
  return { page, context, complaints };
}

/** The picture, small: 96 by 96 pixels as RGBA numbers. */
export async function picture(page: Page): Promise<number[]> {
  return page.evaluate(() => {
    const stage = (window.surpassStudio ?? window.surpassReport)!.stage;
    stage.viewer.draw();
    const small = document.createElement('canvas');
    small.width = small.height = 96;
    const context = small.getContext('2d')!;
    context.drawImage(stage.viewer.canvas, 0, 0, 96, 96);
    return [...context.getImageData(0, 0, 96, 96).data];
  });
}

/** The part of pixels that differ by more than a few steps. */
export function difference(a: readonly number[], b: readonly number[]): number {
  let differing = 0;
  for (let i = 0; i < a.length; i += 4) {
    const off = [0, 1, 2].reduce((sum, c) => sum + Math.abs(a[i + c]! - b[i + c]!), 0);
    if (off > 12) ++differing;
  }
  return differing / (a.length / 4);
}

export function colours(pixels: readonly number[]): number {
  const seen = new Set<number>();
  for (let i = 0; i < pixels.length; i += 4) seen.add((pixels[i]! >> 3 << 10) | (pixels[i + 1]! >> 3 << 5) | (pixels[i + 2]! >> 3));
  return seen.size;
}

/** A picture that is not this one. */
export async function changedFrom(page: Page, before: readonly number[], least = 0.004): Promise<number[]> {
  let after = before as number[];
  await expect.poll(async () => {
    after = await picture(page);
    return difference(before, after);
  }, { timeout: 45000, interval: 60 }).toBeGreaterThan(least);
  return after;
}

/** In the page: the part of each half's width and height that is not ground. */
export function halves(): number[][] {
  const { viewer } = window.surpassStudio!.stage;
  viewer.draw();
  const canvas = document.createElement('canvas');
  const [w, h] = [canvas.width, canvas.height] = [200, 200];
  const context = canvas.getContext('2d')!;
  context.drawImage(viewer.canvas, 0, 0, w, h);
  const { data } = context.getImageData(0, 0, w, h);
  return [0, 1].map((half) => {
    let [left, right, low, high] = [w, 0, h, 0];
    for (let y = 0; y < h; ++y) {
      for (let x = (half * w) / 2; x < ((half + 1) * w) / 2; ++x) {
        const at = 4 * (y * w + x);
        if ([0, 1, 2].every((c) => Math.abs(data[at + c]! - data[c]!) < 24)) continue;
        [left, right, low, high] = [Math.min(left, x), Math.max(right, x), Math.min(low, y), Math.max(high, y)];
      }
    }
    return [(right - left) / (w / 2), (high - low) / h];
  });
}

export const radio = (page: Page, name: string): Locator => page.getByRole('radio', { name, exact: true });
export const verdict = (page: Page): Locator => page.locator('.verdict');
