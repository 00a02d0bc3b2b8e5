// What is seen in the scene, in words, for whoever does not see it.
import { local, unitPrinted } from "./text";
import { type Units, unitIn } from "./units";
import type { Line } from "./wire";

/** Of what the player draws: where the bodies are at every frame. planar: x, y and the angle of each, else x, y, z and four of a quaternion */
export interface Poses {
  planar: boolean;
  names: string[];
  columns: number[][];
  t0: number;
  dt: number;
  n_frames: number;
}
interface Words {
  language: string;
  units: Units;
  atTime: string;
  turnedBy: string;
  more: string;
}

const MOST = 6; // of bodies, and of curves, that are told
const ENERGY = ["kinetic_energy", "potential_energy", "work"];

/** To three digits, without an exponent where it can be. */
export function shortOf(value: number, language = "en"): string {
  const rounded = Number(value.toPrecision(3));
  return local(Math.abs(rounded) < 1e-9 ? "0" : String(rounded), language);
}

/** Where the bodies are, and what is measured, at a time. selected: the body that is told alone */
export function spoken(poses: Poses, lines: Line[], time: number, selected: string | null, words: Words): string {
  const short = (value: number) => shortOf(value, words.language);
  const behind = (unit: string) => (unit === "1" ? "" : `${unit === "deg" ? "" : " "}${unitPrinted(unit)}`); // 60° has no space
  const lengths = unitIn("m", words.units);
  const frame = Math.max(0, Math.min(poses.n_frames - 1, poses.dt > 0 ? Math.round((time - poses.t0) / poses.dt) : 0));
  const stride = poses.planar ? 3 : 7, axes = poses.planar ? ["x", "y"] : ["x", "y", "z"];
  const bodies = poses.names.map((name, k) => {
    const at = (c: number) => poses.columns[stride * k + c]?.[frame] ?? 0;
    const place = axes.map((axis, c) => `${axis} = ${short(at(c) * lengths.factor)}${behind(lengths.unit)}`).join(", ");
    const angle = poses.planar ? `, ${words.turnedBy} ${short((at(2) * 180) / Math.PI)}°` : "";
    return { name, said: `${name}: ${place}${angle}` };
  });
  const told = bodies.some((body) => body.name === selected) ? bodies.filter((body) => body.name === selected) : bodies;
  const unit = lines.find((line) => !ENERGY.includes(line.name))?.unit;
  const measured = lines.filter((line) => line.unit === unit && !ENERGY.includes(line.name)).flatMap((line) => {
    const value = line.values[frame];
    return value == null ? [] : [`${line.name} = ${short(value)}${behind(unit!)}`];
  });
  const rest = told.length > MOST ? [words.more.replace("{}", String(told.length - MOST))] : [];
  return [`${words.atTime} ${short(time)} s`, ...told.slice(0, MOST).map((body) => body.said), ...rest, ...measured.slice(0, MOST)].join("; ") + ".";
}
