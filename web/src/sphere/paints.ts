// What the things of a view are painted with: shaders so plain that a processor draws them at the pace of a hand. All
// that can be said at a corner is said there; a pixel takes what it is given. Lines have their own soft edges, so that
// they need no finer picture to look smooth.
import {Color, DoubleSide, ShaderMaterial, Vector2, Vector3, Vector4} from "three";

/** What all paints of a view are told anew before it is drawn. */
export interface Sight {
  /** Half of the picture, in its own pixels, and how many of these make a CSS pixel. */
  half: {value: Vector2};
  ratio: {value: number};
  /** Towards the eye, and how far that way the ball's outline lies. */
  eye: {value: Vector4};
  light: {value: Vector3};
}
export function new_sight(): Sight {
  return {
    half: {value: new Vector2(1, 1)},
    ratio: {value: 1},
    eye: {value: new Vector4(0, 0, 1, 0)},
    light: {value: new Vector3(0, 0, 1)},
  };
}
export abstract class Paint extends ShaderMaterial {
  abstract set_color(css: string): void;
}

export interface LineLook {
  /** CSS pixels; on the far side of the ball where that is another one. */
  width: number;
  far_width: number;
  opacity: number;
  far_opacity: number;
  dashed: boolean;
}
const dash = {length: 0.045, period: 0.08};

/** Of strips of triangles (strips.ts): laid towards the eye. */
export class LinePaint extends Paint {
  constructor(sight: Sight, {width, far_width, opacity, far_opacity, dashed}: LineLook) {
    super({
      uniforms: {
        half_size: sight.half,
        ratio: sight.ratio,
        eye: sight.eye,
        color: {value: new Color()},
        widths: {value: new Vector2(width, far_width)},
        opacities: {value: new Vector2(opacity, far_opacity)},
      },
      defines: dashed ? {DASHED: ""} : {},
      vertexShader: `
        attribute vec3 behind, before;
        attribute float side;
        #ifdef DASHED
        attribute float along;
        varying float v_along;
        #endif
        uniform vec2 half_size, widths;
        uniform vec4 eye;
        uniform float ratio;
        varying float v_across, v_half, v_facing;
        void main() {
          mat4 seen = projectionMatrix * modelViewMatrix;
          vec4 here = seen * vec4(position, 1.0), from = seen * vec4(behind, 1.0), to = seen * vec4(before, 1.0);
          vec2 way = (to.xy / to.w - from.xy / from.w) * half_size;
          float size = length(way);
          v_facing = dot(position, eye.xyz) - eye.w;
          v_half = 0.5 * ratio * (v_facing < 0.0 ? widths.y : widths.x);
          v_across = side * (v_half + 1.0);
          if (size > 0.0) here.xy += vec2(-way.y, way.x) / size * v_across / half_size * here.w;
          #ifdef DASHED
          v_along = along;
          #endif
          gl_Position = here;
        }`,
      fragmentShader: `
        uniform vec3 color;
        uniform vec2 opacities;
        varying float v_across, v_half, v_facing;
        #ifdef DASHED
        varying float v_along;
        #endif
        void main() {
          float opacity = v_facing < 0.0 ? opacities.y : opacities.x;
          #ifdef DASHED
          if (mod(v_along, ${dash.period.toFixed(4)}) > ${dash.length.toFixed(4)}) discard;
          #endif
          gl_FragColor = vec4(color, opacity * clamp(v_half + 0.5 - abs(v_across), 0.0, 1.0));
        }`,
      transparent: true,
      depthWrite: false,
      side: DoubleSide,
    });
  }
  set_color(css: string): void {
    (this.uniforms.color!.value as Color).set(css).convertLinearToSRGB();
  }
}

/** Of solids and surfaces, from both sides alike: lit, or of one colour. */
export class SurfacePaint extends Paint {
  constructor(sight: Sight, is_lit: boolean, opacity: number) {
    super({
      uniforms: {light: sight.light, color: {value: new Color()}, strength: {value: opacity}},
      defines: is_lit ? {LIT: ""} : {},
      vertexShader: `
        uniform vec3 color, light;
        varying vec3 v_color;
        vec3 on_screen(vec3 c) {
          return mix(1.055 * pow(c, vec3(0.41666)) - 0.055, 12.92 * c, vec3(lessThanEqual(c, vec3(0.0031308))));
        }
        void main() {
          vec4 at = modelMatrix * vec4(position, 1.0);
          #ifdef LIT
          vec3 out_of = normalize(mat3(modelMatrix) * normal);
          if (dot(out_of, cameraPosition - at.xyz) < 0.0) out_of = -out_of;
          vec3 sky = mix(vec3(0.17, 0.2, 0.25), vec3(0.55), 0.5 + 0.5 * out_of.z);
          v_color = on_screen(min(color * (sky + 0.67 * max(dot(out_of, light), 0.0)), 1.0));
          #else
          v_color = on_screen(color);
          #endif
          gl_Position = projectionMatrix * viewMatrix * at;
        }`,
      fragmentShader: `
        varying vec3 v_color;
        uniform float strength;
        void main() { gl_FragColor = vec4(v_color, strength); }`,
      transparent: opacity < 1,
      depthWrite: opacity === 1,
      side: DoubleSide,
    });
  }
  set_color(css: string): void {
    (this.uniforms.color!.value as Color).set(css);
  }
}

/** Of the disc that a ball is seen as, corners at distance 1 from its middle: clearer in the middle, behind all else. */
export class BallPaint extends Paint {
  constructor(opacity: number) {
    super({
      uniforms: {color: {value: new Color()}, strength: {value: opacity}},
      vertexShader: `
        varying vec2 v_at;
        void main() {
          v_at = position.xy;
          gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
        }`,
      fragmentShader: `
        uniform vec3 color;
        uniform float strength;
        varying vec2 v_at;
        void main() {
          float away = dot(v_at, v_at), opacity = strength * (0.12 + 0.88 * away * away);
          gl_FragColor = vec4(color * opacity, opacity);
        }`,
      depthTest: false,
      depthWrite: false,
    });
  }
  set_color(css: string): void {
    (this.uniforms.color!.value as Color).set(css).convertLinearToSRGB();
  }
}
