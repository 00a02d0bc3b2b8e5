// Where something changes along the sliders: found once the text rests, first by formulas, then by motions.
import { Latest, debounced } from "./latest";
import { together } from "./marking";
import { leave } from "./server";
import type { Studio } from "./state.svelte";
import type { Mark, Range } from "./wire";

const TOPIC = "marks";

export class Marks {
  /** For what they were found, and where they are. */
  private found = $state.raw<{ key: string; marks: Mark[] }>({ key: "", marks: [] });
  private slid = $state(""); // the parameter that was moved last: its marks do not hang on where it is
  private finding = new Latest();

  constructor(private studio: Studio) {}

  private get key(): string {
    const { text, language, until } = this.studio;
    return JSON.stringify([text, language, until]);
  }

  find = debounced(900, (ranges: Range[]) => {
    const { text, language, until, model, isCurrent } = this.studio, key = this.key;
    if (this.studio.isShared || this.studio.isNotebook || !ranges.length || !isCurrent || !model || this.found.key === key) return;
    void leave(TOPIC); // nobody waits for those of another text
    this.finding.run(async () => {
      let marks: Mark[] = [];
      for (const kind of ["marks", "changes"] as const) {
        if (key !== this.key) return;
        const told = await this.studio.asked(kind, { text, language, until, ranges }, TOPIC);
        if (!told || told.status === "replaced" || key !== this.key) return;
        marks = together(marks, told.answer?.marks ?? [], ranges);
        this.found = { key, marks };
      }
    });
  });

  of(name: string): Mark[] {
    return this.isKnown(name) ? this.found.marks.filter((mark) => mark.name === name) : [];
  }
  private isKnown(name: string): boolean {
    return this.found.key === this.key || this.slid === name;
  }

  /** The text changes: by one parameter that is moved, whose marks stay, or otherwise. */
  while(name: string, change: () => void): void {
    const isKnown = this.isKnown(name);
    change();
    this.slid = isKnown ? name : "";
  }
  changed(): void {
    this.slid = "";
  }
}
