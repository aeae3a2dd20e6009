import {svelte} from "@sveltejs/vite-plugin-svelte";
import type {Plugin} from "vite";
import {defineConfig} from "vitest/config";

/** What the studio sends as a header (apps/cli/workbench_server.cpp) stands in the page too, for hosts that send none. */
const policy =
  "default-src 'self'; script-src 'self' 'wasm-unsafe-eval'; style-src 'self' 'unsafe-inline'; img-src 'self' data: blob:; " +
  "worker-src 'self' blob:; connect-src 'self'; object-src 'none'; base-uri 'none'; form-action 'none'";
const content_policy: Plugin = {
  name: "content-policy",
  apply: "build",
  transformIndexHtml: () => [
    {tag: "meta", attrs: {"http-equiv": "Content-Security-Policy", content: policy}, injectTo: "head-prepend"},
    {tag: "meta", attrs: {name: "referrer", content: "no-referrer"}, injectTo: "head"},
  ],
};

export default defineConfig({
  base: "./", // any static host, any folder
  plugins: [svelte(), content_policy],
  build: {outDir: "../build/web", emptyOutDir: true, target: "es2022", chunkSizeWarningLimit: 900},
  worker: {format: "es"},
  test: {
    // Against hanging alone: ten times what the slowest took on a busy machine.
    testTimeout: 300_000,
    hookTimeout: 600_000,
    // One place for all files: starting one for each would take as long as the tests.
    pool: "threads",
    isolate: false,
    maxWorkers: "100%",
    projects: [
      {
        extends: true,
        test: {
          name: "node",
          include: ["src/**/*.test.ts", "tests/**/*.test.ts"],
          exclude: ["**/*.dom.test.ts"],
          setupFiles: ["tests/load_texts.ts"],
        },
      },
      {
        extends: true,
        resolve: {conditions: ["browser"]},
        server: {fs: {allow: [".."]}},
        test: {
          name: "page",
          environment: "happy-dom",
          environmentOptions: {happyDOM: {width: 1440, height: 900}},
          include: ["src/**/*.dom.test.ts"],
          setupFiles: ["tests/page/browser.ts", "tests/load_texts.ts", "tests/page/hooks.ts"],
        },
      },
    ],
  },
});
