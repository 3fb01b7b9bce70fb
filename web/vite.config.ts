// Two pages from one code base: the studio, a folder of static files; and the report, one file into
// which the command line puts its data.
import { resolve } from 'node:path';
import { defineConfig } from 'vite';
import { coreFile, oneFile, plainScripts, sampleFile } from './build/plugins';

const kSamples = ['jug.obj', 'twisted_ring.obj', 'trefoil.ply', 'mixed_polygons.obj', 'crease_boundary.obj',
  'double_torus.obj', 'cube.obj', 'blob.stl'];
const kBuilt = resolve(import.meta.dirname, '../build');

export default defineConfig(({ mode }) => {
  const studio = mode === 'studio';
  return {
    base: './',
    logLevel: 'warn',
    plugins: studio ? [coreFile(), sampleFile(kSamples), plainScripts(['core.js', 'samples.js'])] : [oneFile()],
    // Licences stay in the scripts.
    esbuild: { legalComments: 'inline' },
    build: {
      outDir: resolve(kBuilt, studio ? 'studio' : 'report'),
      emptyOutDir: true,
      target: 'es2022',
      chunkSizeWarningLimit: 2000,
      modulePreload: false,
      rollupOptions: {
        input: resolve(import.meta.dirname, studio ? 'index.html' : 'report.html'),
        output: { format: 'iife', entryFileNames: '[name].js', assetFileNames: '[name][extname]', inlineDynamicImports: true },
      },
    },
  };
});
