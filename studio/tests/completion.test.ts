import { describe, expect, test } from "vitest";
import { offered, pathAt } from "../src/completion";

const schema = {
  properties: {
    bodies: { additionalProperties: { properties: { rod: { $ref: "#/$defs/Rod" }, at: {} } } },
    space: { anyOf: [{ type: "boolean" }, { properties: { up: { enum: ["y", "z"] } } }] },
  },
  $defs: { Rod: { description: "a thin rod", anyOf: [{ properties: { mass: {}, length: {} } }, { type: "array" }] } },
};

function at(text: string) {
  const place = text.indexOf("|");
  return pathAt(text.replace("|", ""), place);
}

describe("the path at a place", () => {
  test.each([
    ["bo|", [], true],
    ["bodies:\n  cr|", ["bodies"], true],
    ["bodies:\n  crank: {r|", ["bodies", "crank"], true],
    ["bodies:\n  crank: {rod: {mass: m, l|", ["bodies", "crank", "rod"], true],
    ["bodies:\n  crank:\n    rod:\n      l|", ["bodies", "crank", "rod"], true],
    ["bodies:\n  a: {rod: {mass: 1}}\nspace: {up: |", ["space", "up"], false],
    ["connections:\n  A: {pin: [ground.A, ro|", ["connections", "A", "pin"], false],
  ])("%j", (text, path, isKey) => {
    const found = at(text);
    expect([found.path, found.isKey]).toEqual([path, isKey]);
  });
});

test("keys are offered through references and alternatives, values where there is a list of them", () => {
  const labels = (path: string[], isKey: boolean) => offered(schema, path, isKey).map((each) => each.label);
  expect(labels([], true)).toEqual(["bodies", "space"]);
  expect(labels(["bodies", "crank"], true)).toEqual(["rod", "at"]);
  expect(labels(["bodies", "crank", "rod"], true)).toEqual(["mass", "length"]);
  expect(labels(["space", "up"], false)).toEqual(["y", "z"]);
});
