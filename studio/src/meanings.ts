// Symbols in formulas and pictures, and what they speak of: what is pointed at lights up wherever it stands.
import type { Meaning } from "./wire";

const bare = (text: string | null) => (text ?? "").replace(/\s/g, "");
const SYMBOLS = "msub, mi, svg text";

/** The symbols of a part of the page, each the outermost that means something. */
export function symbolsIn(host: Element, meanings: Meaning[]): [Element, Meaning][] {
  const known = new Map(meanings.map((meaning) => [bare(meaning.symbol), meaning]));
  const found: [Element, Meaning][] = [];
  for (const each of host.querySelectorAll(SYMBOLS)) {
    const meaning = known.get(bare(each.textContent));
    if (meaning && !found.some(([outer]) => outer.contains(each))) found.push([each, meaning]);
  }
  return found;
}

/** Whether a symbol and what is pointed at speak of the same. */
export function isLit(meaning: Meaning, lit: { symbol: string; bodies: string[]; owner: string } | null): boolean {
  if (!lit) return false;
  if (lit.symbol) return lit.symbol === meaning.symbol;
  return lit.bodies.some((body) => meaning.bodies.includes(body));
}
