// The model as a program in Python.

/** A text as Python writes it, over several lines. */
function quoted(text: string): string {
  const escaped = text.replaceAll("\\", "\\\\").replaceAll('"""', '\\"\\"\\"');
  return `"""\\\n${escaped}${escaped.endsWith("\n") ? "" : "\n"}"""`;
}

/** Reads the model, prints its answers, and follows its motion to a time [s]. */
export function scriptOf(text: string, until: number, hasQuestions: boolean): string {
  const answers = hasQuestions ? "print(system.solve())\n" : "";
  return `import freebody as fb\n\nsystem = fb.System.from_text(\n    ${quoted(text)}\n)\n${answers}motion = system.simulate(${until})\nprint(motion)\n`;
}
