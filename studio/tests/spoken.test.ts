import { expect, test } from "vitest";
import { shortOf, spoken } from "../src/spoken";
import { SI } from "../src/units";

const words = { language: "en", units: SI, atTime: "At", turnedBy: "turned by", more: "{} more" };
const line = (name: string, unit: string, values: (number | null)[]) => ({ name, label: name, math: "", unit, values });
const rod = { planar: true, names: ["rod"], columns: [[0.25, 0.5], [-0.43301, 0], [-Math.PI / 3, 0]], t0: 0, dt: 0.5, n_frames: 2 };

test("a number has three digits", () => {
  expect(["-60", "1e-12", "1234.5", "0.0012345"].map((each) => shortOf(Number(each)))).toEqual(["−60", "0", "1230", "0.00123"]);
});

test("the scene says where a body is at the time that is shown", () => {
  const lines = [line("theta", "rad", [-1.0472, 0]), line("kinetic_energy", "J", [0, 1])];
  expect(spoken(rod, lines, 0, null, words)).toBe("At 0 s; rod: x = 0.25 m, y = −0.433 m, turned by −60°; theta = −1.05 rad.");
  expect(spoken(rod, lines, 0.5, null, words)).toBe("At 0.5 s; rod: x = 0.5 m, y = 0 m, turned by 0°; theta = 0 rad.");
});

test("of many bodies the one that is selected is told, or the first ones", () => {
  const names = Array.from({ length: 9 }, (_, k) => `b${k}`);
  const poses = { planar: false, names, columns: names.flatMap((_, k) => [[k], [0], [0], [1], [0], [0], [0]]), t0: 0, dt: 0, n_frames: 1 };
  expect(spoken(poses, [], 0, "b7", words)).toBe("At 0 s; b7: x = 7 m, y = 0 m, z = 0 m.");
  expect(spoken(poses, [], 0, null, words)).toMatch(/b5: x = 5 m, y = 0 m, z = 0 m; 3 more\.$/);
});

test("a value that is not there is not told", () => {
  expect(spoken(rod, [line("theta", "rad", [null, 1])], 0, null, words)).not.toContain("theta");
});

test("numbers are written as the language writes them", () => {
  const german = { language: "de", units: SI, atTime: "Zur Zeit", turnedBy: "gedreht um", more: "{} mehr" };
  expect(spoken(rod, [line("a", "m/s^2", [-0.5, 0])], 0.2, null, german)).toBe("Zur Zeit 0,2 s; rod: x = 0,25 m, y = −0,433 m, gedreht um −60°; a = −0,5 m/s².");
});

test("lengths and angles are told in the units that are chosen", () => {
  const told = spoken(rod, [line("theta", "deg", [-60, 0])], 0, null, { ...words, units: { length: "cm", angle: "deg" } });
  expect(told).toBe("At 0 s; rod: x = 25 cm, y = −43.3 cm, turned by −60°; theta = −60°.");
});
