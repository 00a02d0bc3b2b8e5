// Symbols in formulas and pictures, and what they speak of: what is pointed at lights up wherever it stands.
import type { Meaning } from "./wire";

/** What is pointed at. symbol: empty where it is a body, or an arrow without a symbol of its own */
export type Lit = Meaning;

const DOTS = /[.\u02d9\u00a8\s]/g; // of rates, which speak of what their symbols do
/** The letters of a symbol, without the dots of rates. */
export const bare = (text: string | null) => (text ?? "").replace(DOTS, "");
const SYMBOLS = "msub, mi, svg text";

/** What a part of a page has that can light up: symbols, and lines of pictures as these mark them. */
export interface Lights {
  symbols: [Element, Meaning][];
  marks: Element[];
}

export const NONE: Lights = { symbols: [], marks: [] };

export function lightsIn(host: Element, meanings: Meaning[]): Lights {
  return { symbols: symbolsIn(host, meanings), marks: [...host.querySelectorAll("[data-of]")] };
}

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

/** The meanings of the symbols, each once, with the letter and the index below it. */
export function named({ symbols }: Lights): { meaning: Meaning; letter: string; below: string }[] {
  return [...new Map(symbols.map(([element, meaning]) => [meaning.symbol, { meaning, ...partsOf(element, meaning.symbol) }])).values()];
}

/** Of a symbol as it stands in a formula or picture; dots of rates are left out. */
function partsOf(element: Element, symbol: string): { letter: string; below: string } {
  const letter = bare(element.children.length > 1 ? element.children[0]!.textContent : null);
  return letter && symbol.startsWith(letter) ? { letter, below: symbol.slice(letter.length) } : { letter: symbol, below: "" };
}

/** What lies under the pointer. */
export function pointedAt({ symbols }: Lights, target: Element): Lit | null {
  const symbol = symbols.find(([element]) => element.contains(target))?.[1];
  const of = target.closest("[data-of]")?.getAttribute("data-of");
  return symbol ?? (of ? meant(of, symbols.map(([, meaning]) => meaning)) : null);
}

/** Of a mark: an arrow speaks of its symbol, where that is its alone. */
function meant(of: string, meanings: Meaning[]): Lit {
  const [kind, name] = split(of), none = { symbol: "", bodies: [], owner: "", forces: [] };
  if (kind === "body") return { ...none, bodies: [name] };
  return meanings.find((meaning) => meaning.forces.length === 1 && meaning.forces[0] === name) ?? { ...none, forces: [name] };
}
const split = (of: string): [string, string] => [of.slice(0, of.indexOf(" ")), of.slice(of.indexOf(" ") + 1)];

/** Whether a symbol and what is pointed at speak of the same. */
export function isLit(meaning: Meaning, lit: Lit | null): boolean {
  if (!lit) return false;
  if (lit.symbol) return lit.symbol === meaning.symbol;
  return lit.bodies.some((body) => meaning.bodies.includes(body)) || lit.forces.some((force) => meaning.forces.includes(force));
}

/** Whether what is pointed at is this body, or this arrow: a force and its reaction are one. */
export function isMarkLit(of: string, lit: Lit | null): boolean {
  const [kind, name] = split(of);
  return lit !== null && (kind === "body" ? lit.bodies : lit.forces).includes(name);
}

export function show({ symbols, marks }: Lights, lit: Lit | null): void {
  for (const [element, meaning] of symbols) element.classList.toggle("lit", isLit(meaning, lit));
  for (const element of marks) element.classList.toggle("lit", isMarkLit(element.getAttribute("data-of")!, lit));
}
