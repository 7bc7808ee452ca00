import { expect, it } from "vitest";
import type { SampleAnswer } from "../wire/messages";
import { answersText } from "./samples";

const asks = (line: number): SampleAnswer => ({
  line,
  text: "How deep?",
  buttons: [],
  answer: "",
  given: false,
});

it.each<[string, number[], string[], string]>([
  ["", [3, 9], ["0.5", "Yes"], "3:0.5\n9:Yes\n"],
  ["3:0.1\n# how deep\npause=OK\n", [3, 3], [".2", ".3"], "# how deep\npause=OK\n3:.2\n3:.3\n"],
])("%s", (before, lines, answers, text) =>
  expect(answersText(before, lines.map(asks), answers)).toBe(text),
);
