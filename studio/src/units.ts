// Units in which lengths and angles are shown that are measured along motions and in sweeps. What is calculated is in SI.
import type { Line } from "./wire";

export const LENGTHS = ["m", "cm", "mm"] as const;
export const ANGLES = ["rad", "deg"] as const;
export interface Units {
  length: (typeof LENGTHS)[number];
  angle: (typeof ANGLES)[number];
}
export const SI: Units = { length: "m", angle: "rad" };

const SIZES: Record<string, number> = { m: 1, cm: 0.01, mm: 0.001, rad: 1, deg: Math.PI / 180 };
const PART = /(\/?)(?<![A-Za-z])(m|rad)(?:\^(\d+))?(?![A-Za-z])/g; // of a product, as "m/s^2" or "N m/rad"

/** A unit of SI in those that are chosen, and by how much its numbers become larger. */
export function unitIn(unit: string, { length, angle }: Units): { unit: string; factor: number } {
  let factor = 1;
  const written = unit.replace(PART, (_all, below: string, part: string, power: string | undefined) => {
    const chosen = part === "m" ? length : angle, n = Number(power ?? 1);
    factor *= SIZES[chosen]! ** (below ? n : -n);
    return `${below}${chosen}${power ? `^${power}` : ""}`;
  });
  return { unit: written, factor };
}

const DIGITS = 7; // as numbers come

export function valuesIn(values: (number | null)[], factor: number): (number | null)[] {
  return factor === 1 ? values : values.map((value) => (value === null ? null : Number((value * factor).toPrecision(DIGITS))));
}

/** Lines as they are shown. */
export function linesIn(lines: Line[], units: Units): Line[] {
  return lines.map((line) => {
    const { unit, factor } = unitIn(line.unit, units);
    return factor === 1 ? line : { ...line, unit, values: valuesIn(line.values, factor) };
  });
}
