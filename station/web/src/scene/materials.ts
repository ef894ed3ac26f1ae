// Paint and materials. Where a processor draws, light is worked out at the corners of triangles and the pixels only
// mix it; where a graphics card does, materials are physical ones. Both take the same paint.

import {
  Color,
  type Material,
  MeshStandardMaterial,
  ShaderMaterial,
  type ShaderMaterialParameters,
  type Side,
  FrontSide,
  type Texture,
  Vector3,
} from "three";

export const kPaint = {
  antifouling: 0x7a2e25,
  topsides: 0x384c60,
  deck: 0x5e7468,
  deckMain: 0x7b4034,
  bulwark: 0xc9cdc6,
  white: 0xe8e9e4,
  machinery: 0x93a299,
  machineryDark: 0x5f6c66,
  steel: 0x8b8f90,
  worn: 0xa8a6a0,
  castIron: 0x4d4944,
  rust: 0x7a4a33,
  chain: 0x6a6159,
  black: 0x181a1b,
  red: 0xb52a1e,
  yellow: 0xe3b01c,
  brass: 0xb08a45,
  rubber: 0x26282a,
  orange: 0xe06a1e,
} as const;

/** How a surface takes the light; colours come by vertex or by instance where asked for. */
export interface Look {
  vertexColors?: boolean;
  roughness?: number;
  metalness?: number;
  side?: Side;
  /** No spray comes to it. */
  dry?: boolean;
}

/**
 * What is painted on it: GLSL with uniforms and a function `vec3 paint(vec3 colour, vec3 place)`, place being that of
 * the geometry, m. seen: it has `vec3 seen(vec3 lit, vec3 place)` as well, of what lies between it and the eye.
 */
export interface Pattern {
  name: string;
  glsl: string;
  seen?: boolean;
  uniforms: Record<string, { value: unknown }>;
}

/** A material with a colour that all of it is multiplied by. */
export type Painted = Material & { color: Color };

/** What light there is, for materials that work it out at the corners; world, linear. */
export interface Light {
  sunTowards: Vector3;
  sun: Color;
  sky: Color;
  ground: Color;
  lampAt: Vector3;
  lamp: Color;
  /** A lamp in the hand: where it is, unit vector to where it shines, its light; black: none. */
  handAt: Vector3;
  handTowards: Vector3;
  hand: Color;
  fog: Color;
  fogDensity: number;
  /** 0 dry .. 1: steel is dark with spray, and mirrors the haze where one looks along it. */
  wet: number;
}

/** GLSL: how much of the haze wet steel mirrors. up: of its normal; facing: cosine to the eye. */
const kMirrors = `
float mirrors(float wet, float up, float facing) {
  float low = 1.0 - clamp(facing, 0.0, 1.0), low2 = low * low;
  return wet * (0.35 + 0.65 * max(up, 0.0)) * (0.05 + 0.45 * low2 * low2 * low);
}
`;
const kWetDark = "(1.0 - 0.4 * wet)";

/**
 * From linear light to the screen: Khronos' neutral tone mapping without its shoulder, and the sRGB curve by square
 * roots, which a processor has, instead of powers, which it has not; off by less than one step of 255.
 */
export const kToScreen = `
vec3 toScreen(vec3 c) {
  float x = min(c.r, min(c.g, c.b));
  c = clamp(c - (x < 0.08 ? x - 6.25 * x * x : 0.04), 0.0, 1.0);
  vec3 s1 = sqrt(c), s2 = sqrt(s1), s3 = sqrt(s2);
  return max(0.662002687 * s1 + 0.684122060 * s2 - 0.323583601 * s3 - 0.0225411470 * c, 0.0);
}
`;

const kVertex = `
uniform vec3 tint;
uniform vec3 sunTowards;
uniform vec3 sun;
uniform vec3 sky;
uniform vec3 ground;
uniform vec3 lampAt;
uniform vec3 lamp;
uniform vec3 handAt;
uniform vec3 handTowards;
uniform vec3 hand;
uniform float fogDensity;
uniform float wet;
varying vec3 vColour;
varying vec3 vLight;
varying vec3 vPlace;
varying float vFog;
${kMirrors}
void main() {
  vec4 place = vec4(position, 1.0);
  vec3 n = normal;
  vColour = tint;
#ifdef USE_INSTANCING
  place = instanceMatrix * place;
  n = mat3(instanceMatrix) * n;
#endif
#ifdef USE_INSTANCING_COLOR
  vColour *= instanceColor;
#endif
#ifdef USE_COLOR
  vColour *= color;
#endif
  vPlace = position;
  vec4 world = modelMatrix * place;
  n = normalize(mat3(modelMatrix) * n);
  vLight = sun * max(dot(n, sunTowards), 0.0) + mix(ground, sky, 0.5 + 0.5 * n.z);
  vec3 to = lampAt - world.xyz;
  float far = length(to);
  float spread = max(far, 3.0); // a lamp is no point to what it hangs on
  vLight += lamp * max(dot(n, to), 0.0) / far * exp2(-1.6 * log2(spread));
  vec3 beam = world.xyz - handAt;
  float reach = max(length(beam), 0.1);
  float cone = smoothstep(0.955, 0.99, dot(beam, handTowards) / reach);
  vLight += hand * cone * max(dot(n, -beam), 0.0) / reach * exp2(-1.2 * log2(max(reach, 2.0))); // kFade of hand_lamp.ts
  vec4 seen = viewMatrix * world;
  vLight *= ${kWetDark};
  float mirrored = mirrors(wet, n.z, dot(n, normalize(cameraPosition - world.xyz)));
  vFog = 1.0 - (1.0 - mirrored) * exp(-fogDensity * fogDensity * seen.z * seen.z);
  gl_Position = projectionMatrix * seen;
}
`;

const kFragment = (pattern: Pattern | undefined): string => `
varying vec3 vColour;
varying vec3 vLight;
varying vec3 vPlace;
varying float vFog;
uniform vec3 fog;
${kToScreen}
${pattern?.glsl ?? ""}
void main() {
  vec3 c = ${pattern ? "paint(vColour, vPlace)" : "vColour"} * vLight;
  ${pattern?.seen ? "c = seen(c, vPlace);" : ""}
  gl_FragColor = vec4(toScreen(mix(c, fog, vFog)), 1.0);
}
`;

class CornerLit extends ShaderMaterial {
  readonly color: Color;

  constructor(parameters: ShaderMaterialParameters, tint: Color) {
    super(parameters);
    this.color = tint;
  }
}

export class Materials {
  private readonly made: Material[] = [];
  private readonly light: Record<keyof Light, { value: unknown }> = {
    sunTowards: { value: new Vector3(0, 0, 1) },
    sun: { value: new Vector3() },
    sky: { value: new Vector3() },
    ground: { value: new Vector3() },
    lampAt: { value: new Vector3() },
    lamp: { value: new Vector3() },
    handAt: { value: new Vector3() },
    handTowards: { value: new Vector3(0, 1, 0) },
    hand: { value: new Vector3() },
    fog: { value: new Vector3() },
    fogDensity: { value: 0 },
    wet: { value: 0 },
  };

  /** physical: for a graphics card. */
  constructor(readonly physical: boolean) {}

  make(look: Look, pattern?: Pattern): Painted {
    const { dry, ...how } = look;
    const light = dry ? { ...this.light, wet: { value: 0 } } : this.light;
    const made = this.physical ? standard(how, pattern, light) : cornerLit(how, pattern, light);
    this.made.push(made);
    return made;
  }

  /** For those that work it out at the corners; the others have three's lights. */
  lit(light: Light): void {
    const u = this.light;
    for (const name of ["sun", "sky", "ground", "lamp", "hand", "fog"] as const)
      (u[name].value as Vector3).set(light[name].r, light[name].g, light[name].b);
    (u.sunTowards.value as Vector3).copy(light.sunTowards);
    (u.lampAt.value as Vector3).copy(light.lampAt);
    (u.handAt.value as Vector3).copy(light.handAt);
    (u.handTowards.value as Vector3).copy(light.handTowards);
    u.fogDensity.value = light.fogDensity;
    u.wet.value = light.wet;
  }

  dispose(): void {
    for (const material of this.made) material.dispose();
  }
}

type Lights = Record<keyof Light, { value: unknown }>;

function cornerLit(look: Look, pattern: Pattern | undefined, light: Lights): Painted {
  const tint = new Color(1, 1, 1);
  return new CornerLit(
    {
      uniforms: { ...light, ...pattern?.uniforms, tint: { value: tint } },
      vertexShader: kVertex,
      fragmentShader: kFragment(pattern),
      vertexColors: look.vertexColors ?? false,
      side: look.side ?? FrontSide,
    },
    tint,
  );
}

function standard(look: Look, pattern: Pattern | undefined, { wet, fog }: Lights): MeshStandardMaterial {
  const made = new MeshStandardMaterial({ roughness: 0.7, metalness: 0.1, ...look });
  made.onBeforeCompile = (shader) => {
    Object.assign(shader.uniforms, pattern?.uniforms, { wet, mirrored: fog });
    shader.vertexShader = shader.vertexShader
      .replace("#include <common>", "#include <common>\nvarying vec3 vPlace;")
      .replace("#include <begin_vertex>", "#include <begin_vertex>\nvPlace = position;");
    const painted = pattern ? "diffuseColor.rgb = paint(diffuseColor.rgb, vPlace);" : "";
    shader.fragmentShader = shader.fragmentShader
      .replace(
        "#include <common>",
        `#include <common>
varying vec3 vPlace;
uniform float wet;
uniform vec3 mirrored;
${kMirrors}
${pattern?.glsl ?? ""}`,
      )
      .replace("#include <color_fragment>", `#include <color_fragment>\n${painted}\ndiffuseColor.rgb *= ${kWetDark};`)
      .replace(
        "#include <roughnessmap_fragment>",
        "#include <roughnessmap_fragment>\nroughnessFactor *= 1.0 - 0.55 * wet;",
      )
      .replace(
        "#include <opaque_fragment>",
        `${pattern?.seen ? "outgoingLight = seen(outgoingLight, vPlace);" : ""}\n#include <opaque_fragment>`,
      )
      .replace(
        "#include <emissivemap_fragment>",
        `#include <emissivemap_fragment>
float upwards = dot(normal, (viewMatrix * vec4(0.0, 0.0, 1.0, 0.0)).xyz);
totalEmissiveRadiance += mirrored * mirrors(wet, upwards, dot(normal, normalize(vViewPosition)));`,
      );
  };
  made.customProgramCacheKey = () => pattern?.name ?? "plain";
  return made;
}

/**
 * Paint that has been at sea: worn and stained by a noise that lies on the piece. scale: of the noise, 1/m; shadeTo: m
 * over the piece's origin, below which it gets darker; 0: nowhere.
 */
export function weathered(noise: Texture, scale: number, shadeTo = 0): Pattern {
  return {
    name: `weathered ${scale} ${shadeTo}`,
    uniforms: { weather: { value: noise } },
    glsl: `
uniform sampler2D weather;
vec3 paint(vec3 colour, vec3 place) {
  vec4 worn = texture2D(weather, (place.xy + place.z * vec2(0.73, 0.41)) * ${scale.toFixed(3)});
  colour *= 0.74 + 0.5 * worn.r;
  float stain = smoothstep(0.62, 0.8, worn.b * 0.55 + worn.r * 0.45);
  colour = mix(colour, vec3(0.2, 0.1, 0.055), 0.5 * stain);
  ${shadeTo > 0 ? `colour *= mix(0.55, 1.0, clamp(place.z * ${(1 / shadeTo).toFixed(3)}, 0.0, 1.0));` : ""}
  return colour;
}
`,
  };
}
