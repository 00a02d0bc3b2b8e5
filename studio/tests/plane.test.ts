import { expect, test } from "vitest";
import { extent, leastSpan, ticks, way } from "../src/plane";

test.each([[0, 1], [-3.2, 4.7], [1e-5, 3e-5], [-700, -20], [0.3, 150]])("an axis from %d to %d has some round marks, all within it", (low, high) => {
  const found = ticks(low, high);
  expect(found.length).toBeGreaterThanOrEqual(2);
  expect(found.length).toBeLessThanOrEqual(7);
  for (const at of found) {
    expect(at).toBeGreaterThanOrEqual(low - 1e-9 * (high - low));
    expect(at).toBeLessThanOrEqual(high + 1e-9 * (high - low));
  }
});
test("where nothing changes there is room round it", () => {
  expect(extent([2, 2])).toEqual([1.8, 2.2]);
  expect(extent([0, 0])).toEqual([-1, 1]);
  expect(extent([null])).toEqual([0, 1]);
  expect(ticks(1, 1)).toEqual([]);
});
test("round-off is drawn as what stays", () => {
  expect(extent([1e-15, -2e-15], leastSpan("rad", 2))).toEqual([-2e-15 - 1, 1e-15 + 1].map((x) => expect.closeTo(x, 9)));
  expect([leastSpan("rad/s^2", 2), leastSpan("m/s", 2), leastSpan("m", 3), leastSpan("N m", 2)]).toEqual([1e-8, 2e-8, 3e-8, 0].map((x) => expect.closeTo(x, 12)));
});
test("a way is interrupted where there is no place", () => expect(way([[0, 1], [2, 3], null, [4, 5]])).toBe("M0.0 1.0L2.0 3.0M4.0 5.0"));
