import { type KeyboardEvent, useEffect, useRef, useState } from "react";
import { type Action, attempt } from "../actions/action";
import { openCalculator, openKeypad, openScratch } from "../actions/go";
import { useHands, worldOf } from "../app/context";
import { SheetsAppearChoice } from "../settings/SheetsAppearChoice";
import { Button } from "../ui/Button";
import type { CommandEntry } from "../wire/messages";
import { t } from "../words/words";
import "./command-line.css";
import { execute } from "./execute";
import {
  argumentsOf,
  commandOf,
  emptyLine,
  isImmediate,
  type LineState,
  recalled,
  sent,
  typed,
} from "./line";
import { ParameterHint } from "./ParameterHint";
import { bringsSheet } from "./preferences";
import { useCommands } from "./table";

/** Keys that mean something of their own while nothing is typed. */
const alone: Record<string, Action> = { k: openKeypad, i: openScratch, F10: openCalculator };

/** Two letters and parameters, with what each parameter is above. */
export function CommandLine() {
  const hands = useHands();
  const table = useCommands();
  const [state, setState] = useState(emptyLine);
  const entry = commandOf(table, state.text);
  const input = useTypedAnywhere();
  const [options, setOptions] = useState(false);

  const openSheet = (command: CommandEntry, text: string) => {
    hands.screen.open({ kind: "command", letters: command.letters, given: argumentsOf(text) });
    setState({ ...state, text: "" });
  };
  const send = (line: LineState) => {
    execute(worldOf(hands), line.text);
    setState(sent(line));
  };
  const name = (line: LineState, command: CommandEntry | undefined) => {
    if (command && isImmediate(command)) send(line);
    else if (command && bringsSheet(command)) openSheet(command, line.text);
    else setState(line);
  };
  const type = (text: string) => {
    const next = typed(state, text, table);
    const command = text.length > state.text.length ? commandOf(table, next.text) : undefined;
    name(next, command === entry ? undefined : command);
  };
  // What is typed before the table has come is done when it comes.
  // biome-ignore lint/correctness/useExhaustiveDependencies: once, when the table comes
  useEffect(() => {
    const before = { ...state, text: state.text.slice(0, -1) };
    if (state.text !== "") name(typed(before, state.text, table), entry);
  }, [table]);
  /** Forgets what was typed; once more, and the field is left. */
  const forget = () => setState({ ...state, text: "", at: state.history.length });
  const press = (event: KeyboardEvent) => {
    const action = state.text === "" ? alone[event.key] : undefined;
    if (action) attempt(action, worldOf(hands));
    else if (event.key === "ArrowUp") setState(recalled(state, -1));
    else if (event.key === "ArrowDown") setState(recalled(state, 1));
    else if (event.key === "Escape" && state.text !== "") forget();
    else if (event.key === "Enter" && state.text.trim() !== "") send(state);
    else return;
    event.preventDefault();
  };
  return (
    <div className="command">
      {options ? (
        <FillInOptions onClose={() => setOptions(false)} />
      ) : (
        <ParameterHint text={state.text} entry={entry} table={table} onSheet={openSheet} />
      )}
      <label
        className="command-box"
        onContextMenu={(event) => {
          event.preventDefault();
          setOptions(true);
        }}
      >
        <span className="hidden-text">{t("Command line")}</span>
        <span aria-hidden="true" className="command-prompt">
          ›
        </span>
        <input
          ref={input}
          data-takes="more"
          value={state.text}
          placeholder={t("Command, such as MX,2")}
          autoComplete="off"
          autoCapitalize="characters"
          spellCheck={false}
          onChange={(event) => type(event.target.value)}
          onKeyDown={press}
        />
      </label>
    </div>
  );
}

/** Menu of the choices when fill-in sheets appear; a right click on the command line brings it. */
function FillInOptions({ onClose }: { onClose: () => void }) {
  return (
    <div className="hint">
      <span>{t("Fill-in sheets appear")}</span>
      <SheetsAppearChoice />
      <Button size="small" onPress={onClose}>
        Done
      </Button>
    </div>
  );
}

/** Letters that nothing else hears go to the command line. */
function useTypedAnywhere() {
  const input = useRef<HTMLInputElement>(null);
  useEffect(() => {
    const hear = (event: globalThis.KeyboardEvent) => {
      const bare = event.key.length === 1 && !event.ctrlKey && !event.altKey && !event.metaKey;
      const nobody = event.target === document.body && !event.defaultPrevented;
      if (bare && nobody && /[a-z0-9&%]/i.test(event.key)) input.current?.focus();
    };
    addEventListener("keydown", hear, true);
    return () => removeEventListener("keydown", hear, true);
  }, []);
  return input;
}
