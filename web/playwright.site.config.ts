import {defineConfig} from "@playwright/test";
import common from "./playwright.config";

// The site as any static server gives it, in a folder of its own; its tests start what they need of servers.
export default defineConfig({
  ...common,
  testDir: "site",
  // When a browser looks for a new service worker, and drops an old one, is its own affair on a busy machine.
  retries: 1,
  outputDir: "../build/site-tests/failures",
  projects: [{name: "site"}],
  webServer: undefined,
});
