import {defineConfig} from "@playwright/test";

// The page as it is built, served as users get it: by `linkwright studio`.
const port = Number(process.env.LINKWRIGHT_PORT ?? 4179);
const program = process.env.LINKWRIGHT_CLI ?? "../build/release/bin/linkwright";
const quiet = [
  "--no-first-run",
  "--disable-background-networking",
  "--disable-component-update",
  "--disable-default-apps",
  "--disable-quic",
  "--disable-sync",
];
const solid_drawing = "--enable-unsafe-swiftshader"; // WebGL without a graphics card; flat drawing does not go through it, which would be slow

export default defineConfig({
  testDir: "e2e",
  outputDir: "../build/web-tests/failures",
  fullyParallel: true,
  forbidOnly: true,
  workers: 2,
  retries: 0,
  // Against hanging alone: ten times what the slowest took on a busy machine.
  timeout: 180_000,
  expect: {timeout: 60_000},
  reporter: [["list"]],
  use: {
    baseURL: `http://127.0.0.1:${port}/`,
    viewport: {width: 1440, height: 900},
    locale: "en-GB",
    timezoneId: "UTC",
    colorScheme: "light",
    acceptDownloads: true,
    screenshot: "only-on-failure",
    trace: "off",
    launchOptions: {
      executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium",
      args: ["--no-sandbox", solid_drawing, ...quiet], // root, as build machines are, gets no sandbox
    },
  },
  projects: [
    {name: "page", testIgnore: "speed.spec.ts"},
    {name: "speed", testMatch: "speed.spec.ts", dependencies: ["page"], fullyParallel: false},
  ],
  webServer: {
    timeout: 600_000,
    command: `${program} studio --port ${port} --folder ${process.env.LINKWRIGHT_WEB ?? "../build/web"}`,
    url: `http://127.0.0.1:${port}/`,
    reuseExistingServer: false,
    gracefulShutdown: {signal: "SIGTERM", timeout: 50_000},
  },
});
