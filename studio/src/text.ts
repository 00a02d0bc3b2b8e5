// Changes of a text.

export interface Change {
  from: number;
  to: number;
  insert: string;
}

/** The one change that makes `after` of `before`: what stands between the common beginning and the common end. */
export function changeBetween(before: string, after: string): Change | null {
  if (before === after) return null;
  const most = Math.min(before.length, after.length);
  let from = 0;
  while (from < most && before.charCodeAt(from) === after.charCodeAt(from)) from++;
  let end = 0;
  while (end < most - from && before.charCodeAt(before.length - 1 - end) === after.charCodeAt(after.length - 1 - end)) end++;
  return { from, to: before.length - end, insert: after.slice(from, after.length - end) };
}

const NUMBER = /^([+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?)(?![\w.^*/+(])(.*)$/s;

/** A quantity as it stands in a file: its number, and what follows it. Null for a formula. */
export function quantityOf(text: string): { value: number; rest: string } | null {
  const found = NUMBER.exec(text);
  return found ? { value: Number(found[1]), rest: found[2] ?? "" } : null;
}

/** Between which numbers a slider moves that begins at a value; its step is a three-hundredth of that. */
export function sliderRange(value: number, isPositive: boolean, unit: string): { min: number; max: number; step: number } {
  const isDegrees = /^\s*(deg|°)/.test(unit);
  const size = value === 0 ? 1 : 10 ** Math.ceil(Math.log10(Math.abs(value) * 1.5));
  const max = isDegrees ? Math.max(isPositive ? 90 : 180, Math.ceil(Math.abs(value) / 90) * 90) : round(Math.max(size * 0.3, Math.abs(value) * 2));
  const step = 10 ** Math.floor(Math.log10(max / 100));
  return { min: isPositive ? step : -max, max, step };
}

const RAISED = "⁰¹²³⁴⁵⁶⁷⁸⁹";

/** A number with so many digits, as it is printed: 3.7·10⁻¹¹ where it is very small or large. */
export function printed(value: number, language: string, digits = 3): string {
  const shown = (each: number) => each.toLocaleString(language, { maximumSignificantDigits: digits }).replace("-", "−");
  const size = Math.abs(value);
  if (size === 0 || (size >= 1e-3 && size < 1e6)) return shown(value);
  const [mantissa, power] = value.toExponential(digits - 1).split("e") as [string, string];
  const exponent = Number(power), sign = exponent < 0 ? "⁻" : "";
  return `${shown(Number(mantissa))}·10${sign}${[...String(Math.abs(exponent))].map((each) => RAISED[Number(each)]).join("")}`;
}

/** A number that is written as in a file, as it is printed: with the sign and the decimal mark of the language. */
export function local(number: string, language: string): string {
  return number.replace("-", "−").replace(".", language === "de" ? "," : ".");
}

/** A unit that is written as in a file, as it is printed: m/s², N·m, °. */
export function unitPrinted(unit: string): string {
  const raised = (power: string) => (power.startsWith("-") ? "⁻" : "") + [...power.replace("-", "")].map((each) => RAISED[Number(each)]).join("");
  return unit.replace(/(?<![A-Za-z])deg(?![A-Za-z])/g, "°").replace(/(\^|\*\*)(-?\d+)/g, (_all, _sign, power: string) => raised(power)).replaceAll("*", "·");
}

const MEASURED = /(?<=\d )[A-Za-z]+(?:\^-?\d+)?(?:[ /*][A-Za-z]+(?:\^-?\d+)?)*/g;

/** Words with the units behind their numbers as they are printed: 37.8 rad/s². */
export function wordsPrinted(words: string): string {
  return words.replace(MEASURED, (unit) => (unit.includes("^") ? unitPrinted(unit) : unit));
}

/** A quantity that stands in a file, as it is printed; a formula as it stands. */
export function quantityPrinted(text: string, language: string): string {
  const quantity = quantityOf(text);
  if (!quantity) return text;
  const unit = unitPrinted(quantity.rest.trim());
  return local(text.slice(0, text.length - quantity.rest.length).trim(), language) + (unit && unit !== "°" ? ` ${unit}` : unit);
}

/** Without the last digits of floating point. */
export function round(value: number): number {
  return Number(value.toPrecision(6));
}

/** From which quantity to which a sweep goes that begins at what stands in a file: from half of it to twice as much. */
export function sweepRange(text: string, isPositive: boolean): [string, string] {
  const quantity = quantityOf(text);
  if (!quantity) return ["", ""];
  const { value, rest } = quantity, around = sliderRange(0, isPositive, rest);
  const ends = value === 0 ? [around.min, around.max] : value > 0 ? [value / 2, value * 2] : [value * 2, value / 2];
  return [`${round(ends[0]!)}${rest}`, `${round(ends[1]!)}${rest}`];
}

/** What stands in a comma-separated table, with the name and unit of each column. */
export function csvOf(columns: { name: string; unit: string; values: (number | string | null)[] }[]): string {
  const quoted = (text: string) => (/[",\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text);
  const head = columns.map((c) => quoted(c.unit && c.unit !== "1" ? `${c.name} [${c.unit}]` : c.name));
  const n = Math.max(0, ...columns.map((c) => c.values.length));
  const rows = Array.from({ length: n }, (_, k) => columns.map((c) => quoted(String(c.values[k] ?? ""))).join(","));
  return [head.join(","), ...rows].join("\n") + "\n";
}
