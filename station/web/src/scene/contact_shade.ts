// Soft dark under what stands on deck: cheap, and it puts things on the ground where no shadows are drawn.

import { BufferAttribute, BufferGeometry, CanvasTexture, Mesh, MeshBasicMaterial } from "three";

/** m, body frame: middle, half sizes of what stands there, turn about z (rad), and how dark 0..1. */
export interface Shade {
  x: number;
  y: number;
  z: number;
  halfX: number;
  halfY: number;
  turn: number;
  dark: number;
}

const kSoft = 0.55; // share of the way in, over which the shade deepens

export function contactShade(shades: readonly Shade[]): Mesh<BufferGeometry, MeshBasicMaterial> {
  const canvas = document.createElement("canvas");
  canvas.width = canvas.height = 64;
  const g = canvas.getContext("2d")!;
  const image = g.createImageData(64, 64);
  for (let y = 0; y < 64; ++y)
    for (let x = 0; x < 64; ++x) {
      const edge = (v: number): number => {
        const t = Math.min(1, Math.max(0, (1 - Math.abs((v - 31.5) / 31.5)) / kSoft));
        return t * t * (3 - 2 * t);
      };
      image.data[4 * (64 * y + x) + 3] = 255 * edge(x) * edge(y);
    }
  g.putImageData(image, 0, 0);
  const position: number[] = [];
  const uv: number[] = [];
  const colour: number[] = [];
  const index: number[] = [];
  for (const s of shades) {
    const from = position.length / 3;
    const c = Math.cos(s.turn);
    const n = Math.sin(s.turn);
    for (const [u, v] of [
      [0, 0],
      [1, 0],
      [1, 1],
      [0, 1],
    ] as const) {
      const x = (2 * u - 1) * (s.halfX + 0.4);
      const y = (2 * v - 1) * (s.halfY + 0.4);
      position.push(s.x + c * x - n * y, s.y + n * x + c * y, s.z);
      uv.push(u, v);
      colour.push(0, 0, 0, s.dark);
    }
    index.push(from, from + 1, from + 2, from, from + 2, from + 3);
  }
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(new Float32Array(position), 3));
  geometry.setAttribute("uv", new BufferAttribute(new Float32Array(uv), 2));
  geometry.setAttribute("color", new BufferAttribute(new Float32Array(colour), 4));
  geometry.setIndex(index);
  const mesh = new Mesh(
    geometry,
    new MeshBasicMaterial({
      map: new CanvasTexture(canvas),
      vertexColors: true,
      transparent: true,
      depthWrite: false,
      polygonOffset: true,
      polygonOffsetFactor: -2,
      polygonOffsetUnits: -2,
    }),
  );
  mesh.renderOrder = 1;
  return mesh;
}
