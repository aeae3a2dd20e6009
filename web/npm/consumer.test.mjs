// The npm package as others have it: packed, installed into a project of its own, there used in node, by the compiler of
// TypeScript and in a page that Vite builds; its README is what that project does.
import {chromium} from "@playwright/test";
import assert from "node:assert/strict";
import {execFileSync, spawn} from "node:child_process";
import {cpSync, mkdtempSync, readdirSync, readFileSync, rmSync, writeFileSync} from "node:fs";
import {tmpdir} from "node:os";
import {join} from "node:path";
import {after, before, test} from "node:test";
import {fileURLToPath} from "node:url";
import {build} from "vite";

const here = fileURLToPath(new URL(".", import.meta.url)),
  root = join(here, "../.."),
  program = process.env.LINKWRIGHT_CLI ?? join(root, "build/release/bin/linkwright"),
  example = join(root, "examples/tailgate.json");
const project = mkdtempSync(join(tmpdir(), "linkwright-npm-"));
const run = (command, ...args) => execFileSync(command, args, {cwd: project, encoding: "utf8", maxBuffer: 1 << 26});
const version = run(program, "--version").trim().split(" ")[1];
const tarball = `linkwright-${version}.tgz`;
const readme = readFileSync(join(here, "README.md"), "utf8");
const block = (language) => readme.match(new RegExp(`\`\`\`${language}\\n([^]*?)\`\`\``))[1];

function near(value, wanted, relative, what) {
  assert.ok(Math.abs(value - wanted) <= relative * Math.abs(wanted), `${what}: ${value}, not ${wanted}`);
}

before(() => {
  for (const folder of ["made", "again"]) run("node", join(here, "pack.mjs"), join(project, folder));
  cpSync(join(here, "consumer"), project, {recursive: true});
  cpSync(example, join(project, "tailgate.json"));
  writeFileSync(join(project, "package.json"), JSON.stringify({name: "consumer", private: true, type: "module"}));
  writeFileSync(join(project, "solve.js"), block("js"));
  writeFileSync(join(project, "page.ts"), block("ts"));
  run("npm", "install", "--offline", "--no-audit", "--no-fund", "--silent", join(project, "made", tarball));
});
after(() => rmSync(project, {recursive: true, force: true}));

test("two packages of the same sources are the same bytes", () => {
  const [one, other] = ["made", "again"].map((folder) => readFileSync(join(project, folder, tarball)));
  assert.ok(one.equals(other));
});
test("the package has its licence and the version of the program", () => {
  const installed = join(project, "node_modules/linkwright"),
    {license, version: own} = JSON.parse(readFileSync(join(installed, "package.json"), "utf8"));
  assert.equal(license, "Apache-2.0");
  assert.equal(own, version);
  assert.deepEqual(
    ["LICENSE", "NOTICE", "README.md"].filter((file) => !readdirSync(installed).includes(file)),
    [],
  );
});
test("node finds what the program finds", () => {
  const {linkages, region} = JSON.parse(run(program, "solve", example, "--region", "-o", "-"));
  const taus = linkages.map(({input, output}) => `${input.coordinate},${output.coordinate}`);
  const found = JSON.parse(run("node", "compare.mjs", example, ...taus));
  assert.equal(found.census.defect_free, region.counts.defect_free);
  assert.equal(found.census.meeting, region.meeting_requirements);
  assert.equal(found.linkages.length, linkages.length);
  for (const [i, wanted] of linkages.entries()) {
    assert.equal(found.linkages[i].type, wanted.type);
    near(found.linkages[i].min_transmission_angle_deg, wanted.min_transmission_angle_deg, 1e-6, "transmission angle");
    for (const [link, length] of Object.entries(wanted.lengths)) near(found.lengths[i][link], length, 1e-9, link);
  }
  assert.match(found.refused, /^line \d+, column \d+: /);
});
test("what the README does in node is done", () => {
  const {linkages} = JSON.parse(run(program, "solve", example, "-o", "-"));
  const wanted = linkages.map((linkage) => `${linkage.type} ${linkage.min_transmission_angle_deg.toFixed(2)}\n`);
  assert.equal(run("node", "solve.js"), wanted.join(""));
});
test("the types are whole, as node and as bundlers resolve them", () => {
  const compiler = join(here, "../node_modules/typescript/bin/tsc"),
    common = ["--strict", "--noEmit", "--target", "es2022", "page.ts", "kinds.ts"];
  run("node", compiler, "--module", "nodenext", ...common);
  run("node", compiler, "--module", "esnext", "--moduleResolution", "bundler", ...common);
});
test("Vite builds a page of it, whose worker answers in a browser", {timeout: 1_200_000}, async () => {
  await build({root: project, configFile: false, logLevel: "error", worker: {format: "es"}, build: {target: "es2022"}});
  const server = spawn(program, ["studio", "--port", "0", "--folder", join(project, "dist")], {
    stdio: ["ignore", "pipe", "ignore"],
  });
  const browser = await chromium.launch({
    executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium",
    args: ["--no-sandbox"], // root, as build machines are, gets no sandbox
  });
  try {
    const [said] = await server.stdout.take(1).toArray();
    const page = await browser.newPage(),
      complaints = [];
    page.on("console", (message) => message.type() === "error" && complaints.push(message.text()));
    page.on("pageerror", (error) => complaints.push(String(error)));
    await page.goto(/http:\S+/.exec(said)[0]);
    await page.waitForFunction(() => document.title.includes("four-bars"), null, {timeout: 600_000}).catch(() => {});
    assert.deepEqual(complaints, []);
    assert.match(await page.title(), /^\d+ of 159600 four-bars; the best: [a-z_]+, 8\d\.\d\d°$/);
  } finally {
    await browser.close();
    server.kill();
  }
});
