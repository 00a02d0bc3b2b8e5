// What the editor says of itself, where the page speaks German; in English it says what stands on the left.

const GERMAN: Record<string, string> = {
  Find: "Suchen",
  Replace: "Ersetzen",
  next: "weiter",
  previous: "zurück",
  all: "alle",
  "match case": "Groß- und Kleinschreibung",
  regexp: "regulärer Ausdruck",
  "by word": "ganze Wörter",
  replace: "ersetzen",
  "replace all": "alle ersetzen",
  close: "schließen",
  "current match": "diese Stelle",
  "on line": "in Zeile",
  "replaced match on line $": "in Zeile $ ersetzt",
  "replaced $ matches": "$ Stellen ersetzt",
  "Go to line": "Zur Zeile",
  go: "gehen",
  Diagnostics: "Fehler und Hinweise",
  "No diagnostics": "keine Fehler",
  Completions: "Vorschläge",
  "Selection deleted": "Auswahl gelöscht",
  "Control character": "Steuerzeichen",
};

export const editorWords = (language: string): Record<string, string> => (language === "de" ? GERMAN : {});
