import { describe, expect, test } from "vitest";
import { changeBetween, csvOf, printed, quantityOf, quantityPrinted, sliderRange, sweepRange, wordsPrinted } from "../src/text";

describe("a change between two texts", () => {
  test.each([
    ["a: 1 m\n", "a: 2 m\n"],
    ["aaa", "aaaa"],
    ["", "x"],
    ["abcabc", "abc"],
    ["m: 1 kg # heavy", "m: 12 kg # heavy"],
  ])("makes the other of the one: %j, %j", (before, after) => {
    const change = changeBetween(before, after)!;
    expect(before.slice(0, change.from) + change.insert + before.slice(change.to)).toBe(after);
  });
  test("is none where nothing changes", () => expect(changeBetween("x", "x")).toBeNull());
  test("is as small as it can be", () => expect(changeBetween("a: 1 m # one", "a: 2 m # one")).toEqual({ from: 3, to: 4, insert: "2" }));
});

describe("a quantity", () => {
  test("has a number and what follows it", () => {
    expect(quantityOf("0.2 m")).toEqual({ value: 0.2, rest: " m" });
    expect(quantityOf("-60 deg")).toEqual({ value: -60, rest: " deg" });
    expect(quantityOf("8e-4 kg m^2")).toEqual({ value: 8e-4, rest: " kg m^2" });
    expect(quantityOf("3")).toEqual({ value: 3, rest: "" });
  });
  test.each(["L/2", "2*L", "kg", "theta_0", "2^x"])("is no formula: %s", (text) => expect(quantityOf(text)).toBeNull());
});

describe("a quantity as it is printed", () => {
  test.each([
    ["9.81 m/s^2", "9,81 m/s²"],
    ["-60 deg", "−60°"],
    ["3 N m", "3 N m"],
    ["2e-3 kg*m^-1", "2e−3 kg·m⁻¹"],
    ["90 deg/s", "90 °/s"],
    ["7", "7"],
    ["L/2", "L/2"],
  ])("%s", (text, shown) => expect(quantityPrinted(text, "de")).toBe(shown));
  test("has a point in English", () => expect(quantityPrinted("0.5 m", "en")).toBe("0.5 m"));
});

test("units behind numbers in words are printed, and formulas stay", () => {
  expect(wordsPrinted("from rest at 37.8 rad/s^2. Write m*v^2 or 2 kg m^2")).toBe("from rest at 37.8 rad/s². Write m*v^2 or 2 kg m²");
});

describe("the range of a slider", () => {
  test.each([[0.2, true], [9.81, true], [1, true], [-60, false], [0, false], [5e-4, true]])("holds the value: %d", (value, isPositive) => {
    const { min, max, step } = sliderRange(value, isPositive, value === -60 ? " deg" : " m");
    expect(min).toBeLessThanOrEqual(value);
    expect(max).toBeGreaterThan(value);
    expect(step).toBeGreaterThan(0);
    if (isPositive) expect(min).toBeGreaterThan(0);
  });
});

test("a table has a head with units, and nothing where there is no value", () => {
  const table = csvOf([{ name: "time", unit: "s", values: [0, 1] }, { name: "a, b", unit: "1", values: [null, 2] }]);
  expect(table).toBe('time [s],"a, b"\n0,\n1,2\n');
});

test("a sweep goes from half of what the file has to twice as much", () => {
  expect(sweepRange("1 m", true)).toEqual(["0.5 m", "2 m"]);
  expect(sweepRange("-60 deg", false)).toEqual(["-120 deg", "-30 deg"]);
  expect(sweepRange("0.3", true)).toEqual(["0.15", "0.6"]);
  const [low, high] = sweepRange("0 m/s", false);
  expect(Number.parseFloat(low)).toBeLessThan(0);
  expect(high).toBe(`${-Number.parseFloat(low)} m/s`);
  expect(sweepRange("a/2", true)).toEqual(["", ""]);
});

test("words in a table are quoted where they have to be", () => {
  expect(csvOf([{ name: "L", unit: "m", values: [1, 2] }, { name: "status", unit: "", values: ["no value", 'a "b", c'] }])).toBe('L [m],status\n1,no value\n2,"a ""b"", c"\n');
});

test("a number is printed with powers of ten where it is very small or large", () => {
  expect([0, 0.25, -12.345, 3.73e-11, -2.5e7].map((value) => printed(value, "en"))).toEqual(["0", "0.25", "−12.3", "3.73·10⁻¹¹", "−2.5·10⁷"]);
  expect(printed(2.44e-12, "de", 2)).toBe("2,4·10⁻¹²");
});
