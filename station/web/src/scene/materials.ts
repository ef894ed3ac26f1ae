// Materials: cheap ones where the processor draws, physical ones where a graphics card does.

import {
  type Material,
  MeshLambertMaterial,
  type MeshLambertMaterialParameters,
  MeshStandardMaterial,
  type MeshStandardMaterialParameters,
  type Texture,
} from "three";

export const kPaint = {
  antifouling: 0x7a2e25,
  topsides: 0x2e3f50,
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
  chain: 0x645850,
  black: 0x181a1b,
  red: 0xb52a1e,
  yellow: 0xe3b01c,
  brass: 0xb08a45,
  rubber: 0x26282a,
  orange: 0xe06a1e,
} as const;

export type Look = MeshLambertMaterialParameters & Pick<MeshStandardMaterialParameters, "roughness" | "metalness">;

export class Materials {
  private readonly made: Material[] = [];

  constructor(private readonly physical: boolean) {}

  /** A material that takes colours by vertex or instance where asked to. */
  make(look: Look): MeshStandardMaterial | MeshLambertMaterial {
    const { roughness = 0.7, metalness = 0.1, ...plain } = look;
    const material = this.physical
      ? new MeshStandardMaterial({ ...plain, roughness, metalness })
      : new MeshLambertMaterial(plain);
    this.made.push(material);
    return material;
  }

  /**
   * Paint that has been at sea: vertex colours, worn and stained by a noise that lies on the piece; shadeTo: m over its
   * origin, from which it is darker downwards; 0: nowhere.
   */
  weathered(look: Look, noise: Texture, name: string, scale = 0.33, shadeTo = 0): Material {
    const material = this.make({ vertexColors: true, ...look });
    material.onBeforeCompile = (shader) => {
      shader.uniforms.weather = { value: noise };
      shader.vertexShader = shader.vertexShader
        .replace("#include <common>", "#include <common>\nvarying vec3 vWorn;")
        .replace("#include <begin_vertex>", "#include <begin_vertex>\nvWorn = position;");
      shader.fragmentShader = shader.fragmentShader
        .replace("#include <common>", "#include <common>\nvarying vec3 vWorn;\nuniform sampler2D weather;")
        .replace(
          "#include <color_fragment>",
          `#include <color_fragment>
  vec2 at = (vWorn.xy + vWorn.z * vec2(0.73, 0.41)) * ${scale.toFixed(3)};
  vec4 worn = texture2D(weather, at);
  diffuseColor.rgb *= 0.78 + 0.44 * worn.r;
  float stain = smoothstep(0.62, 0.8, worn.b * 0.55 + worn.r * 0.45);
  diffuseColor.rgb = mix(diffuseColor.rgb, vec3(0.2, 0.1, 0.055), 0.5 * stain);
  diffuseColor.rgb *= 0.9 + 0.2 * texture2D(weather, at * 5.3).b;
  ${shadeTo > 0 ? `diffuseColor.rgb *= mix(0.55, 1.0, smoothstep(0.0, ${shadeTo.toFixed(2)}, vWorn.z));` : ""}`,
        );
    };
    material.customProgramCacheKey = () => name;
    return material;
  }

  dispose(): void {
    for (const material of this.made) material.dispose();
  }
}
