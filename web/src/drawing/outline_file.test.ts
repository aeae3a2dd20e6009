import {describe, expect, it} from "vitest";
import {preset, preset_names} from "./outline_presets";
import {dxf_polyline, outline_of_file, straight_points} from "./outline_file";

const lwpolyline = [
  "0",
  "SECTION",
  "2",
  "ENTITIES",
  "0",
  "LWPOLYLINE",
  "90",
  "4",
  "70",
  "1",
  "10",
  "0",
  "20",
  "0",
  "10",
  "80",
  "20",
  "0",
  "10",
  "80",
  "20",
  "20",
  "10",
  "0",
  "20",
  "20",
  "0",
  "ENDSEC",
  "0",
  "EOF",
].join("\r\n");

describe("outlines of other programs", () => {
  it("are the polyline of a DXF file", () => {
    expect(dxf_polyline(lwpolyline)).toEqual([
      [0, 0],
      [80, 0],
      [80, 20],
      [0, 20],
    ]);
    expect(outline_of_file("lid.dxf", lwpolyline, 100)).toEqual([
      [0, 0],
      [80, 0],
      [80, 20],
      [0, 20],
    ]);
  });
  it("are the vertices of the old kind, or a chain of lines", () => {
    const vertex = (x: number, y: number) => ["0", "VERTEX", "10", `${x}`, "20", `${y}`];
    const old = [
      "0",
      "POLYLINE",
      "66",
      "1",
      "10",
      "0",
      "20",
      "0",
      ...vertex(1, 2),
      ...vertex(3, 4),
      ...vertex(5, 0),
      "0",
      "SEQEND",
    ].join("\n");
    expect(dxf_polyline(old)).toEqual([
      [1, 2],
      [3, 4],
      [5, 0],
    ]);
    const line = (a: number[], b: number[]) => [
      "0",
      "LINE",
      "10",
      `${a[0]}`,
      "20",
      `${a[1]}`,
      "11",
      `${b[0]}`,
      "21",
      `${b[1]}`,
    ];
    const chain = [...line([0, 0], [10, 0]), ...line([10, 0], [5, 8]), ...line([5, 8], [0, 0])].join("\n");
    expect(outline_of_file("a.dxf", chain, 10)).toEqual([
      [0, 0],
      [10, 0],
      [5, 8],
    ]);
  });
  it("are moved to the body's origin and sized when far off", () => {
    const far = lwpolyline
      .replace(/80/g, "9080")
      .replace("10\r\n0\r\n20\r\n0\r\n10", "10\r\n9000\r\n20\r\n0\r\n10")
      .replace("10\r\n0\r\n20\r\n20", "10\r\n9000\r\n20\r\n20");
    expect(outline_of_file("a.dxf", far, 100)).toEqual([
      [-40, -10],
      [40, -10],
      [40, 10],
      [-40, 10],
    ]);
    expect(outline_of_file("a.dxf", lwpolyline, 8000)![1]).toEqual([8000, 0]);
  });
  it("are nothing where there is no polyline", () => {
    expect(outline_of_file("a.dxf", "nonsense", 10)).toBeNull();
    expect(outline_of_file("a.dxf", "", 10)).toBeNull();
  });
  it("are the corners of a path of straight strokes", () => {
    expect(straight_points("M10 20h30v-10L10,10z")).toEqual([
      [10, -20],
      [40, -20],
      [40, -10],
      [10, -10],
    ]);
    expect(straight_points("m1e1,0 5,5 -5.5.5")).toEqual([
      [10, -0],
      [15, -5],
      [9.5, -5.5],
    ]);
    expect(straight_points("M0 0C1 1 2 2 3 3")).toBeNull();
  });
});

it("presets are simple shapes of about the size asked for", () => {
  for (const name of preset_names) {
    const points = preset(name, 150),
      xs = points.map((p) => p[0]),
      ys = points.map((p) => p[1]);
    expect(points.length).toBeGreaterThanOrEqual(4);
    expect(Math.max(Math.max(...xs) - Math.min(...xs), Math.max(...ys) - Math.min(...ys))).toBeGreaterThan(120);
  }
});
