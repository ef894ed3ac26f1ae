// The hull: the server's own mesh, painted by height, with a strake up to the rail.

import { BufferAttribute, BufferGeometry, Color, DoubleSide, Mesh, type Texture, Vector2, type Vector4 } from "three";
import type { SceneDescription } from "../wire/generated";
import { kBulwark, portEdge, raised } from "./hull_outline";
import { type Materials, type Pattern, kPaint } from "./materials";
import { type V3, along, sub } from "./vec";

const kCrease = Math.cos((40 * Math.PI) / 180);
const kBootTop = 1.0; // m over the waterline, up to which the bottom's colour goes

/**
 * Both in the body frame. water: the colour, linear, of what she is seen through below the surface, and how much of it.
 * foc: m, x of the forecastle's after end; deck: m, its height.
 */
export function hullMesh(
  scene: SceneDescription,
  materials: Materials,
  noise: Texture,
  water: { value: Vector4 },
  foc: number,
  deck: number,
): Mesh {
  const pipe = scene.tackle[0]?.mouth ?? { x: 0, z: -99 };
  const paint = hullPaint(noise, water, new Vector2(pipe.x, pipe.z));
  const material = materials.make({ roughness: 0.55, metalness: 0, side: DoubleSide }, paint);
  const mesh = new Mesh(withStrake(scene, foc, deck), material);
  mesh.name = "hull";
  return mesh;
}

/** pipe: m, x and z of the hawse pipes' mouths. */
const hullPaint = (noise: Texture, water: { value: Vector4 }, pipe: Vector2): Pattern => ({
  name: "hull",
  uniforms: {
    hullWorn: { value: noise },
    hullBottom: { value: new Color(kPaint.antifouling) },
    hullSide: { value: new Color(kPaint.topsides) },
    hullWater: water,
    hullPipe: { value: pipe },
  },
  glsl: `
uniform sampler2D hullWorn;
uniform vec3 hullBottom;
uniform vec3 hullSide;
uniform vec4 hullWater;
uniform vec2 hullPipe;
// 1 on a line of a lattice that is so wide, m; fainter where a pixel has more than the line
float seam(float at, float pitch) {
  float wide = 0.014 + fwidth(at);
  return 0.014 / wide * smoothstep(wide, 0.5 * wide, abs(fract(at / pitch + 0.5) - 0.5) * pitch);
}
vec3 paint(vec3 colour, vec3 p) {
  float edge = clamp((p.z - ${kBootTop.toFixed(2)}) * 16.0 + 0.5, 0.0, 1.0);
  vec3 c = mix(hullBottom, hullSide, edge) * colour;
  // streaks run down, scum along the waterline
  float streak = texture2D(hullWorn, vec2(p.x * 0.071 + p.y * 0.03, p.z * 0.009)).r;
  c *= 0.7 + 0.6 * streak;
  c = mix(c, vec3(0.2, 0.095, 0.05), 0.5 * smoothstep(0.6, 0.8, streak) * clamp((p.z - 0.5) * 0.2, 0.0, 1.0));
  // strakes and butts, these by turns
  c *= 1.0 - 0.4 * max(seam(p.z, 2.3), seam(p.x + 3.1 * mod(floor(p.z / 2.3 + 0.5), 2.0), 8.4));
  // rust and mud that run down from the hawse pipe, and paint that its cable has scraped off there
  float below = hullPipe.y - p.z;
  float wide = 1.1 + 0.1 * below;
  float runs = texture2D(hullWorn, vec2(p.x * 0.9, p.z * 0.045)).r;
  float under = smoothstep(wide, 0.3 * wide, abs(p.x - hullPipe.x)) * smoothstep(-0.6, 0.4, below);
  c = mix(c, vec3(0.19, 0.085, 0.04), under * smoothstep(0.3, 0.75, runs) * exp2(-0.16 * max(below, 0.0)));
  c = mix(c, vec3(0.07, 0.09, 0.05), 0.4 * clamp(1.0 - 2.0 * abs(p.z - 0.1), 0.0, 1.0));
  return c;
}
// through water it is soon lost in what the water is
vec3 seen(vec3 lit, vec3 p) {
  return mix(lit, hullWater.rgb, hullWater.a * (1.0 - exp2(1.2 * min(p.z + 0.1, 0.0))));
}
`,
  seen: true,
});

/** The server's triangles and the strake, normals smooth but for creases. */
function withStrake(scene: SceneDescription, foc: number, deck: number): BufferGeometry {
  const triangles: V3[] = [];
  const corner = (n: number): V3 => [
    scene.hull_corners[3 * n]!,
    scene.hull_corners[3 * n + 1]!,
    scene.hull_corners[3 * n + 2]!,
  ];
  for (const n of scene.hull_triangles) triangles.push(corner(n));
  const edge = portEdge(scene);
  const top = edge[0]?.z ?? 0;
  const [lower, upper] = ahead(raised(edge, 0), raised(edge, deck + kBulwark - top), foc);
  for (const side of [1, -1])
    for (let i = 0; i + 1 < lower.length; ++i) {
      const [p, q, r, s] = [lower[i]!, lower[i + 1]!, upper[i + 1]!, upper[i]!].map((c): V3 => [
        c[0],
        side * c[1],
        c[2],
      ]);
      if (side > 0) triangles.push(p!, s!, r!, p!, r!, q!);
      else triangles.push(p!, q!, r!, p!, r!, s!);
    }
  return creased(triangles);
}

/** The parts of two lines of as many points ahead of x of the first: the mesh's own corners, so that no gap is left. */
function ahead(lower: readonly V3[], upper: readonly V3[], x: number): [V3[], V3[]] {
  const found: [V3[], V3[]] = [[], []];
  lower.forEach((p, i) => {
    if (p[0] < x) return;
    const before = lower[i - 1];
    if (found[0].length === 0 && before && before[0] < x) {
      const t = (x - before[0]) / (p[0] - before[0]);
      found[0].push(along(before, t, sub(p, before)));
      found[1].push(along(upper[i - 1]!, t, sub(upper[i]!, upper[i - 1]!)));
    }
    found[0].push(p);
    found[1].push(upper[i]!);
  });
  return found;
}

/** Triangles, three corners each, with the normal of each corner smoothed over neighbours less than 40 degrees off. */
function creased(corners: readonly V3[]): BufferGeometry {
  const normals: V3[] = [];
  const meeting = new Map<string, number[]>(); // triangles by place
  const key = (p: V3): string => p.map((v) => Math.round(v * 1000)).join();
  for (let t = 0; t + 2 < corners.length; t += 3) {
    const [a, b, c] = [corners[t]!, corners[t + 1]!, corners[t + 2]!];
    const u = [b[0] - a[0], b[1] - a[1], b[2] - a[2]] as const;
    const v = [c[0] - a[0], c[1] - a[1], c[2] - a[2]] as const;
    normals.push([u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]]); // by area
    for (const p of [a, b, c]) {
      const list = meeting.get(key(p)) ?? [];
      meeting.set(key(p), list);
      list.push(t / 3);
    }
  }
  const position = new Float32Array(3 * corners.length);
  const normal = new Float32Array(3 * corners.length);
  corners.forEach((p, i) => {
    const own = normals[Math.floor(i / 3)]!;
    const ownLength = Math.hypot(...own) || 1;
    const sum = [0, 0, 0];
    for (const t of meeting.get(key(p))!) {
      const n = normals[t]!;
      const cosine = (n[0] * own[0] + n[1] * own[1] + n[2] * own[2]) / ((Math.hypot(...n) || 1) * ownLength);
      if (cosine > kCrease) for (const k of [0, 1, 2]) sum[k]! += n[k]!;
    }
    const l = Math.hypot(sum[0]!, sum[1]!, sum[2]!) || 1;
    position.set(p, 3 * i);
    normal.set([sum[0]! / l, sum[1]! / l, sum[2]! / l], 3 * i);
  });
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(position, 3));
  geometry.setAttribute("normal", new BufferAttribute(normal, 3));
  return geometry;
}
