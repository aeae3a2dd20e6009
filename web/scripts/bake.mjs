// What the page shows before its engine has loaded: the first example's answers, and a small map with the best linkage of
// every example. Runs the engine in node; writes src/engine/generated/stored.json and
// thumbnails.json, which src/engine/stored.ts reads.
import {deflateSync} from "fflate";
import {existsSync, readdirSync, readFileSync, writeFileSync} from "node:fs";
import {basename} from "node:path";
import {fileURLToPath} from "node:url";
import {runnerImport} from "vite";

const start_name = "tailgate",
  start_samples = 200,
  census_samples = 400,
  thumbnail_samples = 64;
const property = "min_transmission_angle_deg";
const folders = ["../../examples/", "../src/gallery/"].map((path) => new URL(path, import.meta.url));
const generated = new URL("../src/engine/generated/", import.meta.url);

async function loaded(file) {
  const path = fileURLToPath(new URL(`../src/${file}`, import.meta.url));
  return (await runnerImport(path)).module;
}
async function loaded_engine() {
  if (!existsSync(new URL("linkwright.mjs", generated))) {
    console.error("bake: the engine is not built: cmake --preset wasm && cmake --build --preset wasm");
    process.exit(1);
  }
  const {load_module} = await loaded("engine/node.ts");
  return load_module();
}

/** Bytes as text. */
const packed = (bytes) => Buffer.from(deflateSync(bytes, {level: 9})).toString("base64");
/** What cells fail: four bytes each. */
const packed_bits = (bits) => packed(new Uint8Array(bits.slice().buffer));
/** Numbers in single precision, which is enough for a picture: column by column, the differences from row to row of their
 *  bits, first all lowest bytes, then the next, for the sake of deflate. */
function packed_numbers(numbers, width = 1) {
  const rows = numbers.length / width,
    bits = new Uint32Array(Float32Array.from(numbers).buffer);
  const bytes = new Uint8Array(4 * bits.length);
  for (let column = 0, at = 0; column < width; ++column) {
    for (let row = 0, last = 0; row < rows; ++row, ++at) {
      const difference = bits[row * width + column] - last;
      last = bits[row * width + column];
      for (let byte = 0; byte < 4; ++byte) bytes[byte * bits.length + at] = difference >> (8 * byte);
    }
  }
  return packed(bytes);
}

function problems() {
  const files = folders.flatMap((folder) =>
    readdirSync(folder)
      .filter((file) => file.endsWith(".json"))
      .map((file) => new URL(file, folder)),
  );
  return files.map((file) => ({name: basename(fileURLToPath(file), ".json"), text: readFileSync(file, "utf8")}));
}

function open(session, {name, text}) {
  if (!session.set_problem(text)) throw new Error(`${name}: ${session.mistakes()}`);
}
const explored = (session, samples) => session.explore(samples, 0, 1, 0, 1, property, 0);
const best_tau = (session) => JSON.parse(session.best(1)).linkages[0]?.tau ?? null;

function start_of(session, problem) {
  open(session, problem);
  const {census} = explored(session, census_samples).map; // the counts do not jump when the engine is there
  const {task, curves, map} = explored(session, start_samples);
  const stored = {
    name: problem.name,
    task: JSON.parse(task),
    curves: {
      tau: packed_numbers(curves.tau),
      center: packed_numbers(curves.center, 3),
      circle: packed_numbers(curves.circle, 3),
      branch: packed(curves.branch.slice()),
    },
    map: {
      samples: start_samples,
      property,
      census: JSON.parse(census),
      tau: packed_numbers(map.input_tau),
      type: packed(map.type.slice()),
      defects: packed(map.defects.slice()),
      fails: packed_bits(map.fails),
    },
  };
  const tau = best_tau(session);
  const {linkage, states} = session.linkage(...tau);
  stored.linkage = linkage_of(JSON.parse(linkage));
  stored.states = packed_numbers(states, state_width);
  const {input, output} = session.live(...tau);
  stored.live = {input: packed_bits(input), output: packed_bits(output)};
  return stored;
}

function thumbnail_of(session, problem) {
  open(session, problem);
  const {map} = explored(session, thumbnail_samples);
  const thumbnail = {
    title: JSON.parse(session.read(problem.text)).title,
    rows: 0,
    columns: 0,
    type: "",
    fails: "",
    linkage: null,
  };
  if (map) {
    const {
      input_tau: {length: rows},
      output_tau: {length: columns},
    } = map;
    Object.assign(thumbnail, {rows, columns, type: packed(map.type.slice()), fails: packed_bits(map.fails)});
  }
  const tau = map && best_tau(session); // a chain is not searched for here
  if (tau) {
    const {type, input, output, six_bar, spherical} = linkage_of(JSON.parse(session.linkage(...tau).linkage));
    const ends = spherical ? ["center_homogeneous", "circle_homogeneous"] : ["center", "circle"],
      pivots = [input, output].flatMap((dyad) => ends.map((end) => dyad[end]));
    if (!six_bar)
      thumbnail.linkage = {tau, type, pivots: pivots.map((point) => point.map((x) => Number(x.toPrecision(6))))};
  }
  return thumbnail;
}

const {linkage_of} = await loaded("engine/adapter.ts"),
  {state_width} = await loaded("contract/replies.ts");
const engine = await loaded_engine();
const session = new engine.Session();
const all = problems();
const stored = {
  version: engine.version(),
  start: start_of(
    session,
    all.find(({name}) => name === start_name),
  ),
};
const thumbnails = Object.fromEntries(all.map((problem) => [problem.name, thumbnail_of(session, problem)]));
for (const [name, value] of Object.entries({stored, thumbnails})) {
  const text = JSON.stringify(value);
  writeFileSync(new URL(`${name}.json`, generated), text);
  console.log(`bake: ${name} of ${all.length} examples, ${(text.length / 1000).toFixed(1)} kB`);
}
