// Three kinds of tests: units; the WebAssembly module against the program; the pages in a browser.
import { defineConfig } from 'vitest/config';

export default defineConfig({
  test: { testTimeout: 150000, hookTimeout: 150000, reporters: ['default'] },
});
