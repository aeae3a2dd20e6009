import {svelte} from "@sveltejs/vite-plugin-svelte";
import {defineConfig} from "vitest/config";

export default defineConfig({
  base: "./", // any static host, any folder
  plugins: [svelte()],
  build: {outDir: "../build/web", emptyOutDir: true, target: "es2022", chunkSizeWarningLimit: 900},
  worker: {format: "es"},
  test: {
    include: ["src/**/*.test.ts", "tests/**/*.test.ts"],
    testTimeout: 30_000,
    hookTimeout: 60_000,
    // One place for all files: starting one for each would take as long as the tests.
    pool: "threads",
    isolate: false,
    maxWorkers: "100%",
  },
});
