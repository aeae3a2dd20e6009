// The module of the engine in two: first.wasm, which holds what a first minute with a four-bar runs, and rest.wasm, which
// first.wasm asks for where it calls into it (src/engine/module.ts). What is run is seen, by binaryen's wasm-split.
// usage: node split_engine.mjs BUILT FOLDER     of BUILT/linkwright.mjs and .wasm; writes FOLDER/linkwright.mjs, first.wasm, rest.wasm
import {execFileSync} from "node:child_process";
import {copyFileSync, mkdirSync, readFileSync, writeFileSync} from "node:fs";
import {join} from "node:path";
import {pathToFileURL} from "node:url";

const [built, folder] = process.argv.slice(2);
const whole = join(built, "linkwright.wasm"),
  watched = join(built, "watched.wasm"),
  profile = join(built, "first.profile");
const example = readFileSync(new URL("../../examples/tailgate.json", import.meta.url), "utf8");
const colour = "min_transmission_angle_deg";

const wasm_split = (...words) =>
  execFileSync("wasm-split", [
    ...words,
    ...["simd", "exception-handling", "mutable-globals"].map((feature) => `--enable-${feature}`),
  ]);

/** What the page asks of a task that it opens, and while it is edited and looked at: whatever type a linkage is of. */
function first_minute({Session, version}) {
  version();
  const session = new Session(),
    problem = JSON.parse(session.read(example)),
    {poses} = problem.task;
  session.notices();
  const open = (changes) => session.set_problem(JSON.stringify({...problem, ...changes}));
  const look_at = (...tau) => {
    for (const ask of ["linkage", "live", "verify"]) session[ask](...tau);
  };
  const look_about = (samples, order) => {
    session.explore(samples, 0, 1, 0, 1, colour, order);
    for (let k = 0; k < 12; ++k) look_at(0.17 * k, 0.41 * k + 0.05);
  };

  open({});
  look_about(400, 0);
  look_about(1000, -1);
  session.explore(400, 0.2, 0.4, 0.3, 0.5, "link_ratio", -1);
  const {tau} = JSON.parse(session.best(10)).linkages[0];
  look_at(...tau);
  session.improve(...tau);
  session.trace(...tau, 10, 20);
  for (const turned of [false, true]) session.halo(2, turned, turned ? 0.2 : 20, 5, 60);
  for (let step = 1; step <= 24; ++step) {
    const moved = poses.map((pose, k) => (k === step % poses.length ? nudged(pose, step) : pose));
    const requirements = {...problem.requirements, min_transmission_angle_deg: 20 + step};
    open({task: {...problem.task, poses: moved}, requirements});
    look_about(100, -1);
    session.best(1);
  }
  open({task: {...problem.task, poses: "here"}});
  session.mistakes();
}
const nudged = ({x, y, theta_deg}, step) => ({x: x + (step % 2 ? 3 : -3) * step, y, theta_deg: theta_deg + step});

async function run_watched() {
  const {default: create_linkwright} = await import(pathToFileURL(join(built, "linkwright.mjs")));
  let exports;
  const engine = await create_linkwright({
    instantiateWasm: (imports, done) => {
      const instance = new WebAssembly.Instance(new WebAssembly.Module(readFileSync(watched)), imports);
      ({exports} = instance);
      done(instance);
      return exports;
    },
  });
  first_minute(engine);
  const {buffer} = Object.values(exports).find((item) => item instanceof WebAssembly.Memory),
    size = exports.__write_profile(0, 0),
    end = buffer.byteLength - size; // nobody runs it again
  exports.__write_profile(end, size);
  return new Uint8Array(buffer, end, size);
}

wasm_split("--instrument", whole, "-o", watched);
writeFileSync(profile, await run_watched());
mkdirSync(folder, {recursive: true});
wasm_split(
  whole,
  `--profile=${profile}`,
  ...["-o1", join(folder, "first.wasm"), "-o2", join(folder, "rest.wasm")],
  ...["--import-namespace=first", "--placeholder-namespace=rest", "--export-prefix=%"],
);
copyFileSync(join(built, "linkwright.mjs"), join(folder, "linkwright.mjs"));
