// Completion of model files: keys from the schema of the reader, names from the model itself.
import type { Completion, CompletionContext, CompletionResult } from "@codemirror/autocomplete";

export type Schema = { [key: string]: unknown };

/** The keys above a place in a text, by indentation and by braces, and whether a key or a value is being written. */
export function pathAt(text: string, place: number): { path: string[]; isKey: boolean; word: string } {
  const before = text.slice(0, place), lines = before.split("\n"), line = lines.pop() ?? "";
  const path: string[] = [];
  let indent = line.length - line.trimStart().length;
  if (line.trim().startsWith("- ")) indent += 1;
  // block keys that stand further left, from the nearest
  for (let k = lines.length - 1; k >= 0 && indent > 0; k--) {
    const found = /^(\s*)(?:- )?([\w.-]+)\s*:(?:\s*(?:#.*)?$|\s)/.exec(lines[k]!);
    if (found && found[1]!.length < indent) {
      path.unshift(found[2]!);
      indent = found[1]!.length;
    }
  }
  // keys of this line, within braces
  const stack: string[] = [];
  let key = "", word = "", isKey = true;
  for (const token of line.match(/[{}[\],:#]|[^{}[\],:#\s]+|\s+/g) ?? []) {
    if (token === "#") return { path, isKey: false, word: "" };
    if (token === "{" || token === "[") { stack.push(token + key); key = ""; word = ""; isKey = token === "{"; }
    else if (token === "}" || token === "]") { stack.pop(); key = ""; word = ""; isKey = false; }
    else if (token === ",") { key = ""; word = ""; isKey = stack.at(-1)?.[0] !== "["; }
    else if (token === ":") { key = word; word = ""; isKey = false; }
    else if (token.trim() === "") { if (word && word !== "-") word += " "; }
    else word = token === "-" ? "" : word.endsWith(" ") ? token : word + token;
  }
  for (const open of stack) if (open.length > 1) path.push(open.slice(1));
  if (!isKey && key) path.push(key);
  return { path, isKey, word: word.trim() };
}

function branches(node: unknown, root: Schema): Schema[] {
  if (typeof node !== "object" || node === null) return [];
  const schema = node as Schema;
  if (typeof schema.$ref === "string") {
    const target = schema.$ref.slice(2).split("/").reduce<unknown>((found, part) => (found as Schema | undefined)?.[part], root);
    return branches(target, root);
  }
  const inner = [...((schema.anyOf as unknown[]) ?? []), ...((schema.oneOf as unknown[]) ?? [])];
  return [schema, ...inner.flatMap((each) => branches(each, root))];
}

/** What the schema says of the values at a path. */
export function schemasAt(root: Schema, path: string[]): Schema[] {
  let found = branches(root, root);
  for (const part of path) {
    found = found.flatMap((schema) => {
      const properties = (schema.properties ?? {}) as Schema;
      const items = schema.type === "array" ? branches(schema.items, root).flatMap((s) => inside(s, part)) : [];
      return [...inside(schema, part).flatMap((s) => branches(s, root)), ...(part in properties ? [] : items.flatMap((s) => branches(s, root)))];
    });
  }
  return found;
}

function inside(schema: Schema, part: string): unknown[] {
  const properties = (schema.properties ?? {}) as Schema;
  if (part in properties) return [properties[part]];
  return typeof schema.additionalProperties === "object" ? [schema.additionalProperties] : [];
}

/** The keys and words that may stand at a path. */
export function offered(root: Schema, path: string[], isKey: boolean): Completion[] {
  const found = new Map<string, Completion>();
  for (const schema of schemasAt(root, path)) {
    if (isKey) {
      for (const [name, value] of Object.entries((schema.properties ?? {}) as Record<string, Schema>)) {
        const info = String(value.description ?? "");
        if (!found.has(name)) found.set(name, { label: name, type: "property", apply: `${name}: `, ...(info ? { info } : {}) });
      }
    } else {
      for (const word of [...((schema.enum as unknown[]) ?? []), ...("const" in schema ? [schema.const] : [])]) {
        if (typeof word === "string") found.set(word, { label: word, type: "constant" });
      }
    }
  }
  return [...found.values()];
}

/** The source of completions. names: of the model, such as crank.end. */
export function completion(schema: () => Schema | null, names: () => string[]): (context: CompletionContext) => CompletionResult | null {
  return (context) => {
    const root = schema(), text = context.state.doc.toString();
    const { path, isKey } = pathAt(text, context.pos);
    const word = context.matchBefore(/[\w.-]*/);
    if (!root || !word || (word.from === word.to && !context.explicit)) return null;
    const options = offered(root, path, isKey);
    if (!isKey) options.push(...names().map((label) => ({ label, type: "variable" })));
    return options.length ? { from: word.from, options, validFor: /^[\w.-]*$/ } : null;
  };
}
