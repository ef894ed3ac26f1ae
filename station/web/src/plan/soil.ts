// Letters that a chart prints for the soil (INT 1, section J).

import { Soil } from "../wire/generated";

const letters: Record<Soil, string> = {
  [Soil.SOIL_MUD]: "M",
  [Soil.SOIL_SAND]: "S",
  [Soil.SOIL_CLAY]: "Cy",
  [Soil.SOIL_GRAVEL]: "G",
  [Soil.SOIL_ROCK]: "R",
  [Soil.SOIL_CORAL]: "Co",
  [Soil.SOIL_MIXED]: "S.M",
};

export const soilLetter = (soil: Soil): string => letters[soil] ?? "";
