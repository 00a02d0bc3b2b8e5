// The editor of the text: YAML with the reader's own messages, their fixes, and completion from the schema.
import { acceptCompletion, autocompletion, closeBrackets, type CompletionContext, type CompletionResult, completionKeymap } from "@codemirror/autocomplete";
import { defaultKeymap, history, historyField, historyKeymap, isolateHistory, redo, redoDepth, undo, undoDepth } from "@codemirror/commands";
import { yaml } from "@codemirror/lang-yaml";
import { bracketMatching, HighlightStyle, indentUnit, syntaxHighlighting } from "@codemirror/language";
import { type Diagnostic, lintGutter, lintKeymap, setDiagnostics } from "@codemirror/lint";
import { closeSearchPanel, highlightSelectionMatches, searchKeymap } from "@codemirror/search";
import { Annotation, Compartment, EditorState, type Text, Transaction } from "@codemirror/state";
import { EditorView, highlightActiveLine, keymap, lineNumbers } from "@codemirror/view";
import { tags } from "@lezer/highlight";
import { editorWords } from "./editorwords";
import type { Studio, Writer } from "./state.svelte";
import type { Remark } from "./wire";

const isLoad = Annotation.define<boolean>();
const look = EditorView.theme({
  "&": { height: "100%", fontSize: "0.8125rem", color: "var(--ink)", backgroundColor: "var(--paper)" },
  ".cm-scroller": { fontFamily: "ui-monospace, 'Cascadia Code', Menlo, Consolas, monospace", lineHeight: "1.55" },
  ".cm-content": { caretColor: "var(--ink)", paddingBlock: "0.5rem" },
  ".cm-gutters": { backgroundColor: "var(--paper)", color: "var(--muted)", border: "none" },
  ".cm-activeLine, .cm-activeLineGutter": { backgroundColor: "color-mix(in srgb, var(--wash) 70%, transparent)" },
  "&.cm-focused > .cm-scroller > .cm-selectionLayer .cm-selectionBackground, .cm-selectionBackground, ::selection": {
    backgroundColor: "color-mix(in srgb, var(--accent) 28%, transparent) !important",
  },
  "&.cm-focused": { outline: "none" },
  // the words that are selected elsewhere: on the paper, so that they are read as well as the rest
  "& .cm-selectionMatch, & .cm-searchMatch": { backgroundColor: "transparent", outline: "1px solid var(--muted)" },
  "& .cm-searchMatch.cm-searchMatch-selected": { outline: "2px solid var(--accent)" },
  ".cm-cursor": { borderLeftColor: "var(--ink)" },
  ".cm-tooltip, .cm-panels": { backgroundColor: "var(--paper)", color: "var(--ink)", border: "1px solid var(--faint)" },
  // as buttons and fields of the page are: the editor's own have a light gradient, on which nothing is read in the dark
  ".cm-panel .cm-button": {
    color: "var(--ink)", backgroundColor: "var(--wash)", backgroundImage: "none", border: "1px solid var(--muted)", borderRadius: "0.3rem", padding: "0.1rem 0.5rem", textTransform: "none",
  },
  ".cm-panel .cm-button:active": { backgroundImage: "none" },
  ".cm-panel .cm-textfield": { color: "var(--ink)", backgroundColor: "var(--paper)", border: "1px solid var(--muted)", borderRadius: "0.3rem" },
  ".cm-panel .cm-textfield::placeholder": { color: "var(--muted)", opacity: "1" },
  ".cm-panel button[name=close]": { color: "var(--ink)", cursor: "pointer", minWidth: "1.5rem", minHeight: "1.5rem" },
  ".cm-tooltip-autocomplete ul li[aria-selected]": { backgroundColor: "var(--accent)", color: "var(--paper)" },
  ".cm-diagnostic": { padding: "0.35rem 0.6rem", whiteSpace: "pre-wrap", maxWidth: "34rem" },
  ".cm-diagnosticAction": {
    color: "inherit", backgroundColor: "var(--wash)", border: "1px solid var(--muted)", borderRadius: "0.3rem", padding: "0.1rem 0.5rem", cursor: "pointer",
  },
});
const colors = HighlightStyle.define([
  { tag: [tags.propertyName, tags.definition(tags.propertyName)], color: "var(--measure)" },
  { tag: tags.comment, color: "var(--muted)", fontStyle: "italic" },
  { tag: [tags.punctuation, tags.separator, tags.squareBracket, tags.brace], color: "var(--muted)" },
]);

/** An editor in an element of the page, whose text is that of the studio. */
export function editorIn(parent: HTMLElement, studio: Studio, complete: (context: CompletionContext) => CompletionResult | null, label: string) {
  const name = new Compartment(), language = new Compartment();
  const spoken = () => EditorState.phrases.of(editorWords(studio.language));
  const named = () => EditorView.contentAttributes.of({ "aria-label": label });
  const extensions = [
    lineNumbers(),
    history({ newGroupDelay: 700, minDepth: 1000 }),
    bracketMatching(),
    closeBrackets(),
    highlightActiveLine(),
    EditorView.lineWrapping,
    highlightSelectionMatches(),
    indentUnit.of("  "),
    yaml(),
    syntaxHighlighting(colors),
    look,
    lintGutter(),
    autocompletion({ override: [complete] }),
    // Tab leaves the editor, as everywhere on the page; it takes a completion that is offered
    keymap.of([{ key: "Tab", run: acceptCompletion }, ...completionKeymap, ...lintKeymap, ...searchKeymap, ...historyKeymap, ...defaultKeymap]),
    EditorView.contentAttributes.of({ tabindex: "0" }), // the text scrolls, so keys must reach it
    EditorView.updateListener.of((update) => {
      if (update.docChanged) {
        const text = update.state.doc.toString();
        studio.moved((place, side) => update.changes.mapPos(place, side), text);
        studio.changed(text);
      }
      studio.canUndo = undoDepth(update.state) > 0;
      studio.canRedo = redoDepth(update.state) > 0;
    }),
  ];
  const all = () => [EditorState.readOnly.of(studio.isShared || !studio.folder.isOpen), language.of(spoken()), name.of(named()), ...extensions];
  const stateOf = (doc: string) => EditorState.create({ doc, extensions: all() });
  const view = new EditorView({ parent, state: stateOf(studio.text) });
  function take(state: EditorState) {
    studio.changed(state.doc.toString()); // what is asked about it is on its way while the editor is made
    const hasFocus = view.hasFocus;
    view.setState(state);
    // out of the page and in again: the browser's own history of what was typed, which nobody uses here, would keep all
    // lines that there ever were
    view.dom.remove();
    parent.append(view.dom);
    if (hasFocus) view.focus();
    [studio.canUndo, studio.canRedo] = [undoDepth(state) > 0, redoDepth(state) > 0];
  }

  const writer: Writer = {
    change(changes, userEvent) {
      const isSlide = userEvent === "input.type.slider";
      view.dispatch({ changes, userEvent, annotations: isSlide ? [] : [isolateHistory.of("full")] });
    },
    load: (text) => take(stateOf(text)),
    kept: () => view.state.toJSON({ history: historyField }),
    restore: (state) => take(EditorState.fromJSON(state, { extensions: all() }, { history: historyField })),
    select(from, to) {
      const most = view.state.doc.length;
      view.dispatch({ selection: { anchor: Math.min(from, most), head: Math.min(to, most) }, scrollIntoView: true, annotations: [isLoad.of(true), Transaction.addToHistory.of(false)] });
    },
    undo: () => undo(view),
    redo: () => redo(view),
    focus: () => view.focus(),
  };
  return {
    view,
    writer,
    /** In the language that the page has now; an open search would go on in the one before. */
    setLabel(text: string) {
      closeSearchPanel(view);
      label = text;
      view.dispatch({ effects: [name.reconfigure(named()), language.reconfigure(spoken())] });
    },
    show(remarks: Remark[]) {
      const told = view.state.doc.toString().trim() ? remarks : []; // an empty page has no mistake
      view.dispatch(setDiagnostics(view.state, told.map((remark) => diagnostic(remark, view.state.doc))));
    },
  };
}

/** A remark on a text. When that has changed, until it is read again, a fix has moved with the remark, and mends
 * nothing where its words are not there any more. */
function diagnostic(remark: Remark, doc: Text): Diagnostic {
  const from = Math.min(remark.span.start, doc.length);
  return {
    from,
    to: Math.min(remark.span.end, doc.length),
    severity: remark.severity,
    message: remark.message,
    actions: remark.fixes.map(({ label, span, text }) => ({
      name: label,
      apply: (view, now) => {
        const [start, end] = [span.start + now - from, span.end + now - from];
        if (start < 0 || view.state.sliceDoc(start, end) !== doc.sliceString(span.start, span.end)) return;
        view.dispatch({ changes: { from: start, to: end, insert: text }, userEvent: "input.fix" });
      },
    })),
  };
}
