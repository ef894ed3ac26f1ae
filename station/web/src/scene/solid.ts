// Many painted pieces as one mesh: what stands still together is drawn with one call.

import {
  BoxGeometry,
  BufferAttribute,
  BufferGeometry,
  Color,
  CylinderGeometry,
  Matrix4,
  Quaternion,
  SphereGeometry,
  TorusGeometry,
  Vector3,
} from "three";
import type { V3 } from "./vec";

const kUp = new Vector3(0, 1, 0); // of three's cylinders

export class Solid {
  private readonly positions: number[] = [];
  private readonly normals: number[] = [];
  private readonly colours: number[] = [];
  private readonly indices: number[] = [];

  /** Adds a geometry, moved by the matrix, in one colour (sRGB hexadecimal). */
  add(geometry: BufferGeometry, colour: number, matrix?: Matrix4): this {
    const from = this.positions.length / 3;
    const placed = matrix ? geometry.clone().applyMatrix4(matrix) : geometry;
    const position = placed.getAttribute("position");
    const normal = placed.getAttribute("normal");
    const paint = new Color(colour);
    for (let i = 0; i < position.count; ++i) {
      this.positions.push(position.getX(i), position.getY(i), position.getZ(i));
      this.normals.push(normal.getX(i), normal.getY(i), normal.getZ(i));
      this.colours.push(paint.r, paint.g, paint.b);
    }
    const index = placed.getIndex();
    const mirrored = matrix !== undefined && matrix.determinant() < 0;
    const count = index ? index.count : position.count;
    for (let i = 0; i < count; i += 3) {
      const corner = (k: number): number => from + (index ? index.getX(i + k) : i + k);
      this.indices.push(corner(0), corner(mirrored ? 2 : 1), corner(mirrored ? 1 : 2));
    }
    return this;
  }

  /** A box with its middle at a place, turned by rad about z. */
  box(at: V3, size: V3, colour: number, turn = 0): this {
    const matrix = new Matrix4().makeRotationZ(turn).setPosition(at[0], at[1], at[2]);
    return this.add(new BoxGeometry(size[0], size[1], size[2]), colour, matrix);
  }

  /** A round bar between two places; other: the radius at its end. */
  bar(from: V3, to: V3, radius: number, colour: number, sides = 8, other = radius): this {
    const a = new Vector3(...from);
    const b = new Vector3(...to);
    const length = a.distanceTo(b);
    if (length === 0) return this;
    const matrix = new Matrix4().compose(
      a.clone().add(b).multiplyScalar(0.5),
      new Quaternion().setFromUnitVectors(kUp, b.clone().sub(a).divideScalar(length)),
      new Vector3(1, 1, 1),
    );
    return this.add(new CylinderGeometry(other, radius, length, sides), colour, matrix);
  }

  ball(at: V3, radius: number, colour: number): this {
    return this.add(new SphereGeometry(radius, 10, 8), colour, new Matrix4().makeTranslation(at[0], at[1], at[2]));
  }

  /** A ring round an axis. */
  ring(at: V3, axis: V3, radius: number, wire: number, colour: number, around = 24, section = 8): this {
    const matrix = new Matrix4().compose(
      new Vector3(...at),
      new Quaternion().setFromUnitVectors(new Vector3(0, 0, 1), new Vector3(...axis).normalize()),
      new Vector3(1, 1, 1),
    );
    return this.add(new TorusGeometry(radius, wire, section, around), colour, matrix);
  }

  /** A flat quadrilateral, counterclockwise from where it is seen. */
  quad(a: V3, b: V3, c: V3, d: V3, colour: number): this {
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", new BufferAttribute(new Float32Array([...a, ...b, ...c, ...d]), 3));
    geometry.setIndex([0, 1, 2, 0, 2, 3]);
    geometry.computeVertexNormals();
    return this.add(geometry, colour);
  }

  /** How many corners it has so far. */
  get corners(): number {
    return this.positions.length / 3;
  }

  build(): BufferGeometry {
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", new BufferAttribute(new Float32Array(this.positions), 3));
    geometry.setAttribute("normal", new BufferAttribute(new Float32Array(this.normals), 3));
    geometry.setAttribute("color", new BufferAttribute(new Float32Array(this.colours), 3));
    geometry.setIndex(this.indices);
    return geometry;
  }
}
