// What vite does not do by itself: pages that open from a folder, without a server.
import { readFileSync } from 'node:fs';
import { resolve } from 'node:path';
import { gzipSync } from 'node:zlib';
import { build as bundle } from 'esbuild';
import type { Plugin } from 'vite';

const kRoot = resolve(import.meta.dirname, '../..');

/** core.js: the worker with the core's glue code before it, and the module. Browsers do not let a
 * page that was opened from a folder fetch files, but they run its scripts. */
export function coreFile(): Plugin {
  return {
    name: 'surpass-core',
    async generateBundle() {
      const glue = readFileSync(resolve(kRoot, 'build/wasm/surpass_core.js'), 'utf8');
      const wasm = readFileSync(resolve(kRoot, 'build/wasm/surpass_core.wasm'));
      const worker = await bundle({
        entryPoints: [resolve(kRoot, 'web/src/core/worker.ts')], bundle: true, write: false, minify: true,
        format: 'iife', target: 'es2022',
      });
      const files = { worker: `${glue}\n${worker.outputFiles[0]!.text}`, wasm: gzipSync(wasm, { level: 9 }).toString('base64') };
      this.emitFile({ type: 'asset', fileName: 'core.js', source: `surpassCoreFiles = ${JSON.stringify(files)};\n` });
    },
  };
}

/** samples.js: a few of the project's meshes, byte for byte. */
export function sampleFile(names: readonly string[]): Plugin {
  return {
    name: 'surpass-samples',
    generateBundle() {
      const samples = Object.fromEntries(names.map((n) => [n, readFileSync(resolve(kRoot, 'data', n)).toString('base64')]));
      this.emitFile({ type: 'asset', fileName: 'samples.js', source: `surpassSamples = ${JSON.stringify(samples)};\n` });
    },
  };
}

/** Modules are not loaded from folders either: the page's scripts become plain ones. */
export function plainScripts(before: readonly string[]): Plugin {
  return {
    name: 'surpass-plain-scripts',
    enforce: 'post',
    transformIndexHtml: (html) => html.replace(/<script type="module" crossorigin src="([^"]+)"><\/script>/, (_all, source: string) =>
      [...before.map((file) => `./${file}`), source].map((s) => `<script defer src="${s}"></script>`).join('\n    '))
      .replace(' crossorigin', ''),
  };
}

/** One file: scripts and styles go into the page. */
export function oneFile(): Plugin {
  return {
    name: 'surpass-one-file',
    enforce: 'post',
    generateBundle(_options, files) {
      const page = Object.values(files).find((f) => f.fileName.endsWith('.html'));
      if (page?.type !== 'asset') throw new Error('there is no page');
      let html = String(page.source);
      for (const file of Object.values(files)) {
        if (file === page) continue;
        const text = file.type === 'chunk' ? file.code : String(file.source);
        // The script goes to the end of the body, behind the data; and must not end its own element.
        if (file.type === 'chunk') {
          html = html.replace(/\s*<script [^>]*src=[^>]*><\/script>/, '')
            .replace('</body>', () => `<script>${text.replaceAll('</script', '<\\/script')}</script>\n  </body>`);
        } else if (file.fileName.endsWith('.css')) {
          html = html.replace(/<link rel="stylesheet"[^>]*>/, () => `<style>${text}</style>`);
        }
        Reflect.deleteProperty(files, file.fileName);
      }
      page.source = html;
    },
  };
}
