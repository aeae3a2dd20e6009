// Solves a problem file with the package as a project of its own has it; writes JSON.
import {readFileSync} from "node:fs";
import {load_engine, Refusal, whole} from "linkwright";

const engine = await load_engine();
const [file, ...taus] = process.argv.slice(2),
  problem = readFileSync(file, "utf8"),
  property = "min_transmission_angle_deg";
const {map} = engine.ask("explore", {problem, samples: 400, window: whole, property, order: "fresh"});
const {linkages} = engine.ask("best", {problem, most: 10});
const lengths = taus.map((tau) => engine.ask("linkage", {problem, tau: tau.split(",").map(Number)}).linkage.lengths);
let refused = null;
try {
  engine.ask("read", {text: problem.slice(0, -9)});
} catch (error) {
  if (error instanceof Refusal) refused = error.message;
}
console.log(JSON.stringify({census: map.census, linkages, lengths, refused}));
