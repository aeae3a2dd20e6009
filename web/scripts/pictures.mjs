// The pictures of the workbench in docs/tutorials, in both languages, of the page as it is built (build/web).
// usage: npm --prefix web run pictures
import {chromium} from "@playwright/test";
import {spawn} from "node:child_process";
import {readFileSync} from "node:fs";
import {fileURLToPath} from "node:url";

const root = new URL("../../", import.meta.url),
  port = 4187;
const tutorials = {
  tailgate: "tailgate",
  wrist: "wrist_orthosis",
  crane: "straight_luffing_crane",
  mixer: "dough_mixer",
};
const path = (place) => fileURLToPath(new URL(place, root));

async function open(browser, language, example) {
  const page = await browser.newPage({viewport: {width: 1280, height: 800}, colorScheme: "light"});
  await page.addInitScript((spoken) => {
    localStorage.setItem("linkwright.preferences", JSON.stringify({language: spoken, theme: "light", toured: true}));
  }, language);
  await page.goto(`http://127.0.0.1:${port}/`);
  await page.waitForFunction(() => globalThis.__linkwright?.ready, null, {timeout: 600_000});
  const text = readFileSync(path(`examples/${example}.json`), "utf8").replace(/^\s*\/\/.*$/gm, "");
  await page.getByTestId("file.menu").click();
  const [chooser] = await Promise.all([page.waitForEvent("filechooser"), page.getByTestId("file.open").click()]);
  await chooser.setFiles({name: `${example}.json`, mimeType: "application/json", buffer: Buffer.from(text)});
  await page.waitForFunction(
    (title) => {
      const {problem, is_current, map, hand, seeker, tau_in_hand} = globalThis.__linkwright.workbench;
      const settled = is_current && map?.samples === 1000 && !seeker.seeking;
      return problem.title === title && settled && hand?.tau.join() === tau_in_hand?.join();
    },
    JSON.parse(text).title,
    {timeout: 600_000},
  );
  await page.locator(".toasts button").last().click(); // what it said of the file
  return page;
}

const studio = spawn(path("build/release/bin/linkwright"), [
  "studio",
  "--port",
  String(port),
  "--folder",
  path("build/web"),
]);
await new Promise((started) => studio.stdout.once("data", started));
const browser = await chromium.launch({
  executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium",
  args: ["--no-sandbox"],
});
try {
  for (const [language, ending] of [
    ["en", ""],
    ["zh", ".zh-CN"],
  ])
    for (const [name, example] of Object.entries(tutorials)) {
      const page = await open(browser, language, example);
      await page.screenshot({path: path(`docs/tutorials/${name}${ending}.png`), animations: "disabled"});
      await page.close();
    }
} finally {
  await browser.close();
  studio.kill("SIGTERM");
}
