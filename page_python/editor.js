/* The editor for a cell, fetched when the first one is opened. */
import { defaultKeymap, history, historyKeymap, indentWithTab } from "@codemirror/commands";
import { python } from "@codemirror/lang-python";
import { bracketMatching, indentUnit, syntaxHighlighting } from "@codemirror/language";
import { EditorState } from "@codemirror/state";
import { EditorView, keymap } from "@codemirror/view";
import { tagHighlighter, tags } from "@lezer/highlight";

// The classes by which Pygments colours a listing, light and dark.
const likeListings = tagHighlighter([
  { tag: tags.comment, class: "c1" },
  { tag: tags.string, class: "s2" },
  { tag: tags.number, class: "mi" },
  { tag: [tags.bool, tags.null], class: "kc" },
  { tag: tags.operatorKeyword, class: "ow" },
  {
    tag: [tags.keyword, tags.controlKeyword, tags.definitionKeyword, tags.moduleKeyword],
    class: "k",
  },
  {
    tag: [tags.definition(tags.className), tags.function(tags.definition(tags.variableName))],
    class: "nf",
  },
  { tag: [tags.operator, tags.definitionOperator], class: "o" },
  { tag: [tags.variableName, tags.propertyName], class: "n" },
]);
const LEAVE = 5000; // How long Tab leaves the editor after Escape.

/** Code without spaces that do not break: Firefox and WebKit type one after a sign, and Python refuses it. */
const asTyped = (code) => code.replaceAll("\u00a0", " ");

/** Open an editor for the code `doc`, with attributes for the element that is edited. */
export function open(parent, doc, attributes, { run, change }) {
  return new EditorView({
    parent,
    doc,
    extensions: [
      keymap.of([
        ...["Shift-Enter", "Mod-Enter"].map((key) => ({ key, run: () => run() ?? true })),
        { key: "Escape", run: (view) => view.setTabFocusMode(LEAVE) ?? true },
        indentWithTab,
        ...historyKeymap,
        ...defaultKeymap,
      ]),
      history(),
      bracketMatching(),
      indentUnit.of("    "),
      EditorState.tabSize.of(4),
      python(),
      syntaxHighlighting(likeListings),
      EditorView.contentAttributes.of(attributes),
      // The theme has keys of its own: a slash would go to the search.
      EditorView.domEventHandlers({ keydown: (event) => void event.stopPropagation() }),
      EditorView.updateListener.of(
        (update) => update.docChanged && change(asTyped(update.state.doc.toString())),
      ),
    ],
  });
}
