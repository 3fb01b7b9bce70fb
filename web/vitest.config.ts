// Three kinds of tests: units; the WebAssembly module against the program; the pages in a browser.
import { defineConfig } from 'vitest/config';

export default defineConfig({
  test: { testTimeout: 40000, hookTimeout: 60000, reporters: ['default'] },
});
