import { createElement } from "react";
import { renderToStaticMarkup } from "react-dom/server";
import { expect, it } from "vitest";
import { type Hands, HandsContext } from "../app/context";
import { nothingShown } from "../link/shown";
import { inches } from "../units/quantity";
import { Button } from "./Button";

const shown = { ...nothingShown, snapshot: { units: inches } };

/** A page whose machine is set to inches. */
const value = { link: { shown: { get: () => shown, watch: () => () => {} } } } as unknown as Hands;

it("the reason of a greyed button is told in the unit of the page", () => {
  const button = createElement(Button, { refused: "the cutter is 12.7 mm wide" }, "Start");
  const page = createElement(HandsContext.Provider, { value }, button);
  expect(renderToStaticMarkup(page)).toContain('title="the cutter is 0.5 in wide"');
});
