// The engine's module (bindings/wasm/bind.cpp). Arrays are views into the engine's memory: to be copied before the next
// call.
import type {DyadPolygon, PlateSizes} from "../contract/messages";
import untyped from "./generated/linkwright.mjs";

export interface MapArrays {
  census: string;
  input_tau: Float64Array;
  output_tau: Float64Array;
  type: Uint8Array;
  defects: Uint8Array;
  fails: Uint32Array;
  value: Float32Array;
  ridge_input: Float32Array;
  ridge_input_partner: Uint32Array;
  ridge_output: Float32Array;
  ridge_output_partner: Uint32Array;
}
export interface Session {
  /** False where the text has mistakes. */
  set_problem(text: string): boolean;
  mistakes(): string;
  read(text: string): string;
  /** Of what was read last. */
  notices(): string;
  explore(
    samples: number,
    input_from: number,
    input_to: number,
    output_from: number,
    output_to: number,
    property: string,
    order: number,
  ): {task: string; curves: DyadPolygon; output_curves: DyadPolygon | null; map: MapArrays | null};
  linkage(input_tau: number, output_tau: number): {linkage: string; states: Float64Array; tolerance: string};
  live(input_tau: number, output_tau: number): {input: Uint32Array; output: Uint32Array};
  tolerance(input_tau: number, output_tau: number, bins: number, drawn: number): {report: string; drawn: Float64Array};
  /** JSON text; empty where there is none. */
  loads(input_tau: number, output_tau: number): string;
  /** JSON text: {"placed"} or {"mistakes"}; empty where the linkage does not get through its positions. */
  place_spring(input_tau: number, output_tau: number, boxes: string, most_boxes: number): string;
  stud_map(input_tau: number, output_tau: number, boxes: string, stud: string, columns: number, rows: number): string;
  sample_yields(cells: number): string;
  front(first: string, second: string): string;
  halo(part: number, turn: boolean, reach: number, steps: number, samples: number): Uint32Array;
  best(most: number): string;
  improve(input_tau: number, output_tau: number): string;
  verify(input_tau: number, output_tau: number): string;
  trace(input_tau: number, output_tau: number, x: number, y: number): Float64Array;
  exported(input_tau: number, output_tau: number, format: string): string;
  /** `plan`: JSON text, a MachinePlan, or {"mistakes"}. Sizes that are 0 are chosen, and a clearance below 0. */
  machine(
    input_tau: number,
    output_tau: number,
    sizes: PlateSizes,
  ): {plan: string; vertices: Float32Array; triangles: Uint32Array; travel: Float64Array};
  machine_file(
    input_tau: number,
    output_tau: number,
    format: string,
    sizes: PlateSizes,
  ): {bytes: Uint8Array<ArrayBuffer>; mistakes: string};
  delete(): void;
}
export interface LinkwrightModule {
  Session: new () => Session;
  /** JSON text: the report of this name, or {"mistakes"}. */
  report(of: string, text: string): string;
  /** JSON text: FitSearchReply, or {"mistakes"}. `tell` hears how much is done, in [0, 1]. */
  search_fits(problem: string, tell: (done: number) => void): string;
  version(): string;
}

/** The engine's code: what a first minute with a four-bar runs, and the rest, which the first calls into
 *  (scripts/split_engine.mjs). A rest that is a function is asked for in the middle of a call that needs it. */
export interface Code {
  first: WebAssembly.Module;
  rest: WebAssembly.Module | (() => WebAssembly.Module);
}
type Create = (hooks: {
  instantiateWasm(imports: WebAssembly.Imports, done: (instance: WebAssembly.Instance) => void): object;
}) => Promise<LinkwrightModule>;
const create = untyped as unknown as Create;

export function create_linkwright(code: Code): Promise<LinkwrightModule> {
  return new Promise((resolve, reject) => {
    const instantiateWasm = (imports: WebAssembly.Imports, done: (instance: WebAssembly.Instance) => void) => {
      instantiate(code, imports).then(done, reject);
      return {};
    };
    create({instantiateWasm}).then(resolve, reject);
  });
}

/** Where the first module has no function of its own it imports one, under its place in the table of functions that both
 *  share; the rest puts the function there. */
async function instantiate({first, rest}: Code, imports: WebAssembly.Imports): Promise<WebAssembly.Instance> {
  let is_whole = false;
  const function_at = (place: string) => {
    return (...values: unknown[]): unknown => {
      if (!is_whole) new WebAssembly.Instance(rest instanceof WebAssembly.Module ? rest : rest(), of_rest);
      is_whole = true;
      return table.get(Number(place))(...values);
    };
  };
  const places = new Proxy<WebAssembly.ModuleImports>({}, {get: (_, place) => function_at(place as string)});
  const instance = await WebAssembly.instantiate(first, {...imports, rest: places}),
    table = Object.values(instance.exports).find((item) => item instanceof WebAssembly.Table)!;
  const of_rest = {...imports, first: instance.exports};
  if (rest instanceof WebAssembly.Module) {
    await WebAssembly.instantiate(rest, of_rest);
    is_whole = true;
  }
  return instance;
}
