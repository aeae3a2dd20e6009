// What is used of the library, which brings no types.
declare module "dxf/lib/parseString" {
  export interface DxfVertex {
    x?: number;
    y?: number;
    bulge?: number;
  }
  interface Common {
    layer?: string;
    visible?: boolean;
    paperSpace?: number;
    extrusionZ?: number;
  }
  interface Xy {
    x: number;
    y: number;
  }
  export interface DxfInsert extends Common, Partial<Xy> {
    type: "INSERT";
    block: string;
    scaleX?: number;
    scaleY?: number;
    /** Degrees. */
    rotation?: number;
    columnCount?: number;
    rowCount?: number;
    columnSpacing?: number;
    rowSpacing?: number;
  }
  export type DxfEntity =
    | DxfInsert
    | (Common & {type: "LINE"; start: Xy; end: Xy})
    | (Common & {
        type: "LWPOLYLINE" | "POLYLINE";
        vertices: DxfVertex[];
        closed?: boolean;
        polygonMesh?: boolean;
        polyfaceMesh?: boolean;
      })
    | (Common & Xy & {type: "CIRCLE"; r: number})
    /** Angles in radians. */
    | (Common & Xy & {type: "ARC"; r: number; startAngle: number; endAngle: number})
    | (Common &
        Xy & {
          type: "ELLIPSE";
          majorX: number;
          majorY: number;
          axisRatio: number;
          startAngle?: number;
          endAngle?: number;
        })
    | (Common & {
        type: "SPLINE";
        controlPoints: Xy[];
        knots: number[];
        weights?: number[];
        degree: number;
        closed?: boolean;
      });
  interface DxfBlock extends Partial<Xy> {
    name: string;
    entities?: DxfEntity[];
  }
  export default function parse(text: string): {
    header: {insUnits?: number};
    blocks: DxfBlock[];
    entities: DxfEntity[];
  };
}
