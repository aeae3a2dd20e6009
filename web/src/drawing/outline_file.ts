// An outline out of a drawing of another program, SVG or DXF, in which the engine finds the shapes; XML is the browser's.
import type {OutlineShape, Outlines} from "../contract/replies";
import {Refusal} from "../engine/refusal";
import type {Workbench} from "../state/workbench.svelte";
import {mistakes_text} from "../texts/mistakes";

const most_bytes = 16e6,
  too_large = {code: "drawing_of_too_much", place: "", values: {}, message: ""};

export function is_outline_file(file: File, svg_too: boolean): boolean {
  return is_dxf(file.name) || (svg_too && (/\.svg$/i.test(file.name) || file.type === "image/svg+xml"));
}
function is_dxf(name: string): boolean {
  return /\.dxf$/i.test(name);
}

/** One at least, as outlines of a body of about this size; or why there is none. */
export async function read_outlines(
  {driver_client, unit}: Pick<Workbench, "driver_client" | "unit">,
  file: File,
  size: number,
): Promise<readonly OutlineShape[] | string> {
  if (file.size > most_bytes) return mistakes_text([too_large]);
  const text = await file.text(),
    drawn = is_dxf(file.name) ? {format: "dxf", text} : {format: "svg", elements: elements_of(text)};
  try {
    const asked = JSON.stringify({...drawn, length_unit: unit, size}),
      {report} = await driver_client!.run({kind: "report", of: "outlines", text: asked});
    return (report as Outlines).shapes;
  } catch (error) {
    if (error instanceof Refusal) return mistakes_text(error.mistakes);
    throw error;
  }
}

type ElementRow = [around: number, name: string, attributes: Record<string, string>];
/** In the order of the document; none where it is no XML. */
function elements_of(text: string): ElementRow[] {
  const document = new DOMParser().parseFromString(text, "image/svg+xml"),
    elements = [...document.getElementsByTagName("*")],
    places = new Map<unknown, number>(elements.map((element, i) => [element, i]));
  if (elements.some(({localName}) => localName === "parsererror")) return [];
  return elements.map((element) => [
    places.get(element.parentNode) ?? -1,
    element.nodeName,
    Object.fromEntries(Array.from(element.attributes, ({name, value}) => [name, value])),
  ]);
}
