// Units in which numbers are shown.
import { expect, test } from "vitest";
import { SI, linesIn, unitIn } from "../src/units";

const FINE = { length: "mm", angle: "deg" } as const;

test.each([["m", "mm", 1e3], ["m/s^2", "mm/s^2", 1e3], ["rad/s", "deg/s", 180 / Math.PI], ["kg m^2/s", "kg mm^2/s", 1e6], ["1/m", "1/mm", 1e-3], ["N m/rad", "N mm/deg", (1e3 * Math.PI) / 180]])(
  "%s becomes %s", (unit, written, factor) => {
    const found = unitIn(unit, FINE);
    expect(found.unit).toBe(written);
    expect(found.factor / factor).toBeCloseTo(1, 12);
  });

test.each(["1", "kg", "N", "J", "mol", "s"])("%s has neither a length nor an angle", (unit) => {
  expect(unitIn(unit, FINE)).toEqual({ unit, factor: 1 });
});

test("in SI nothing changes, and gaps stay", () => {
  const line = { name: "x", label: "x", math: "", unit: "m", values: [1, null] };
  expect(linesIn([line], SI)[0]).toBe(line);
  expect(linesIn([line], FINE)[0]).toEqual({ ...line, unit: "mm", values: [1000, null] });
});
